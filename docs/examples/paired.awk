# Compares the sketches of one sweep with its first sketch:
#
#   awk -F, -f paired.awk TABLE
#   awk -F, -v value=lap_best_s -v off_line_s=0.2 -f paired.awk TABLE
#
# For each other sketch and map, prints the mean difference of `value` (default time_s): the other sketch's value minus
# the first one's. Adds the 95 % confidence interval of the normal distribution, which needs 30 seeds or more. A pair
# is one seed, robot and target for which both sketches reached the goal. Neither sketch may be off the line for more
# than `off_line_s` seconds (default 1).
BEGIN { if (value == "") value = "time_s"; if (off_line_s == "") off_line_s = 1 }
NR == 1 {
  for (i = 1; i <= NF; i++) column[$i] = i
  if (!(value in column)) { print "the table has no column " value; failed = 1; exit 1 }
  next
}
NR == 2 { first = $column["sketch"] }
{
  world = $column["map"] FS $column["robot"] FS $column["target"] FS $column["seed"]
  followed = $column["verdict"] == "reached" && $column["off_line_s"] <= off_line_s
  if ($column["sketch"] == first) { if (followed) before[world] = $column[value]; next }
  row = $column["sketch"] " - " first ", " $column["map"]
  if (!(row in n)) { rows[++count] = row; n[row] = 0 }
  if (!followed || !(world in before)) next
  difference = $column[value] - before[world]
  n[row]++
  sum[row] += difference
  squares[row] += difference * difference
}
END {
  if (failed) exit 1
  for (i = 1; i <= count; i++) {
    row = rows[i]
    if (n[row] < 2) { print row ": fewer than two pairs"; continue }
    mean = sum[row] / n[row]
    half = 1.96 * sqrt((squares[row] - n[row] * mean * mean) / (n[row] * (n[row] - 1)))
    printf "%s: %s %.3f, 95 %% interval %.3f .. %.3f, %d pairs\n", row, value, mean, mean - half, mean + half, n[row]
  }
}
