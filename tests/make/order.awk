# The order of compilation, as rules for make: an object waits for the objects of the modules its
# `use` lines name; a program is linked from the objects it needs and no others, and so is the library,
# which is made of its faces for Fortran and C. `twins` are files of other folders, each in the place
# of the module of src it is named as; LOFT-mpi is linked with them.
#     awk -v objects=build/release -v loft=build/loft -v library=build/release/libloft.o \
#         -v twins=mpi/a/b.f90 \
#         -f modules.awk -f order.awk FILE...

# A file without its ending; a module that is not in the tree gets a name that make can't make.
function stem_of(module,    file) {
    file = module in path ? path[module] : "no-such-module/" module
    sub(/\.f90$/, "", file)
    return file
}

function object_of(module) { return objects "/" stem_of(module) ".o" }

# The executable of a program: `loft` for the one in src, the path of the source for a test.
function program_of(module) {
    return path[module] ~ /^src\// ? loft : objects "/" stem_of(module)
}

# The object of the twin of a module, or of the module itself where it has none.
function twin_of(module) {
    return module in twin ? objects "/" twin[module] ".o" : object_of(module)
}

BEGIN {
    n = split(twins, name)
    for (i = 1; i <= n; i++) {
        twin[module_of(name[i])] = name[i]
        sub(/\.f90$/, "", twin[module_of(name[i])])
    }
}

END {
    for (module in path) {
        n = split(uses[module], name)
        for (i = 1; i <= n; i++) print object_of(module) ": " object_of(name[i])
        if (module ~ /^api_(loft|c_.*)$/) whole = library
        else if (module in is_program) whole = program_of(module)
        else continue
        split("", needs)
        mark_needs(module, needs)
        print whole ": " object_of(module)
        for (need in needs) print whole ": " object_of(need)
        if (twins == "" || whole != loft) continue
        print loft "-mpi: " object_of(module)
        for (need in needs) print loft "-mpi: " twin_of(need)
    }
}
