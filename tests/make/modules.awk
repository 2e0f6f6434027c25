# What the tree says of itself: layers, names, `use` lines. Read first by the scripts that draw the
# order of compilation (order.awk), the picture (graph.awk) and the lint (../lint/lint.awk).

# A layer is a folder of src; it may use itself and the layers named here.
BEGIN {
    layers = "base geom deck body cut report export period audit sweep api app"    # bottom to top
    below["base"]   = ""
    below["geom"]   = "base"
    below["deck"]   = "base"
    below["body"]   = "base geom deck"
    below["cut"]    = "base geom body"
    below["report"] = "base geom deck body cut"
    below["export"] = "base geom body cut"
    below["period"] = "base deck report"
    below["audit"]  = "base geom deck report"
    below["sweep"]  = "base geom deck body cut report"
    below["api"]    = "base geom deck body cut report export period audit sweep"
    below["app"]    = layers
    for (i = 1; i < ARGC; i++) if (ARGV[i] ~ /\.f90$/) path[module_of(ARGV[i])] = ARGV[i]
}

# The name a module must have in the file src/geom/arc.f90 or tests/support/tap.f90. A file of mpi/
# stands for that of src/ with the same name.
function module_of(file) {
    sub(/^(src|tests|mpi)\//, "", file)
    sub(/\.f90$/, "", file)
    gsub(/\//, "_", file)
    return file
}

# The layer of a module.
function layer_of(module) {
    sub(/_.*/, "", module)
    return module
}

# True where a module of one layer may use a module of another.
function may_use(layer, other) {
    return layer == other || index(" " below[layer] " ", " " other " ") > 0
}

# The module a `use` line names; nothing for other lines, for intrinsic modules and for that of MPI.
function used(line) {
    line = tolower(line)
    if (line !~ /^ *use[ ,:]/ || line ~ /^ *use *, *intrinsic/) return ""
    sub(/^ *use *(, *non_intrinsic *)?(:: *)?/, "", line)
    sub(/[^a-z0-9_].*/, "", line)
    return line == "mpi_f08" ? "" : line
}

# Marks every module that a module needs, at first or second hand.
function mark_needs(module, needs,    name, n, i) {
    n = split(uses[module], name)
    for (i = 1; i <= n; i++) {
        if (name[i] in needs) continue
        needs[name[i]] = 1
        mark_needs(name[i], needs)
    }
}

FNR == 1 { module = module_of(FILENAME) }
/^ *program +[a-z]/ { is_program[module] = 1 }
used($0) != "" { uses[module] = uses[module] " " used($0) }
{ lines[module] = FNR }
