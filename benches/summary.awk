# The lines of docs/dev/performance.md, from the tables that solver_speed printed. Fails where a table has lost a row.
#
# usage: awk -f benches/summary.awk results.md

BEGIN { FS = " *[|] *" }

/^Measured/ { measured = $0; sub(/;.*/, "", measured) }
/^### / { section = $0; making = 0 }
section ~ /libm/ { in_exp[$2] = $4 + 0 }
section ~ /table of one's own/ && $2 ~ /^cubic Hermite/ { hermite = $8 + 0 }
section ~ /table of one's own/ && $2 ~ /^the same over arrays/ { hermite_batch = $5 + 0 }
section ~ /^### Making a model/ && $3 ~ /^[0-9.]+ [mu]s/ {
    split($3, of, " ")
    ms = of[2] == "us" ? of[1] / 1000 : of[1]
    if (least == "" || ms < least) least = ms
    if (ms > most) most = ms
}
section ~ /^### Two threads/ && $2 ~ /^the fastest/ { threads = $3 }
section ~ /^### Memory/ && $2 ~ /^largest set/ { memory = $3 }

END {
    if (measured == "" || !("scalar mu" in in_exp) || !("batch mu" in in_exp) || !("batch F and dF/dP" in in_exp) ||
        !hermite || !hermite_batch || least == "" || !threads || !memory) {
        print "benches/summary.awk: a table of the results has lost a row" > "/dev/stderr"
        exit 1
    }
    printf "- A scalar call costs %.2f `exp`: it returns the friction coefficient at a load.\n", in_exp["scalar mu"]
    printf "- A contact in a batch costs %.2f `exp`, and %.2f with the slope dF/dP.\n",
        in_exp["batch mu"], in_exp["batch F and dF/dP"]
    printf "- A cubic table of your own, well written and as accurate, takes %.1f times as long per call and " \
        "%.1f times in a batch.\n", hermite, hermite_batch
    printf "- Making a model takes %.1f to %.1f ms, once per pair of surfaces. It then occupies at most %.0f KiB.\n",
        least, most, memory
    printf "- Two threads on one model do %.1f times the work of one.\n", threads
    printf "- %s.\n", measured
}
