# Puts a section of one page into another, between the lines `<!-- make bench -->` and `<!-- end -->`.
#     awk -f section.awk -v name=Audit performance.md audit.md
FNR == NR {
    if (/^## /) wanted = index($0, "## " name) == 1
    else if (wanted) text = text $0 "\n"
    next
}
/^<!-- end -->$/ { inside = 0 }
!inside
/^<!-- make bench -->$/ { inside = 1; printf "%s", text }
