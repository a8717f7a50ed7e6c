# Compares the sketches of one sweep with its first sketch:  awk -F, -f paired.awk TABLE
# For each other sketch and map, prints the mean difference of time_s (that sketch minus the first one) with its
# 95 % confidence interval (of the normal distribution: use 30 seeds or more). A pair is one seed, robot and target
# for which both sketches reached the goal.
NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
NR == 2 { first = $column["sketch"] }
{
  world = $column["map"] FS $column["robot"] FS $column["target"] FS $column["seed"]
  reached = $column["verdict"] == "reached"
  if ($column["sketch"] == first) { if (reached) time[world] = $column["time_s"]; next }
  row = $column["sketch"] " - " first ", " $column["map"]
  if (!(row in n)) { rows[++count] = row; n[row] = 0 }
  if (!reached || !(world in time)) next
  difference = $column["time_s"] - time[world]
  n[row]++
  sum[row] += difference
  squares[row] += difference * difference
}
END {
  for (i = 1; i <= count; i++) {
    row = rows[i]
    if (n[row] < 2) { print row ": fewer than two pairs"; continue }
    mean = sum[row] / n[row]
    half = 1.96 * sqrt((squares[row] - n[row] * mean * mean) / (n[row] * (n[row] - 1)))
    printf "%s: %.3f s, 95 %% interval %.3f .. %.3f s, %d pairs\n", row, mean, mean - half, mean + half, n[row]
  }
}
