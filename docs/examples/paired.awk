# Compares two sketches of one sweep:  awk -F, -f paired.awk TABLE
# Prints the mean difference of time_s, second sketch minus first sketch, with its 95 % confidence interval (of
# the normal distribution: use 30 seeds or more). A pair is one seed for which both sketches reached the goal.
NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
NR == 2 { first = $column["sketch"] }
$column["verdict"] == "reached" {
  world = $column["map"] FS $column["robot"] FS $column["target"] FS $column["seed"]
  if ($column["sketch"] == first) { time[world] = $column["time_s"]; next }
  if (!(world in time)) next
  second = $column["sketch"]
  difference = $column["time_s"] - time[world]
  n++
  sum += difference
  squares += difference * difference
}
END {
  if (n < 2) { print "fewer than two pairs"; exit 1 }
  mean = sum / n
  half = 1.96 * sqrt((squares - n * mean * mean) / (n * (n - 1)))
  printf "%s - %s: %.3f s, 95 %% interval %.3f .. %.3f s, %d pairs\n", second, first, mean, mean - half, mean + half, n
}
