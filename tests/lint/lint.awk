# The rules of the source that the compiler does not know. Prints `file:line: what is wrong` for
# each fault and ends with status 1 where there is any. From the root of the tree:
#     awk -f tests/make/modules.awk -f tests/lint/lint.awk FILE...
# Every rule is broken once, on purpose, in lint.t.

BEGIN {
    widest = 100; longest_file = 300; longest_procedure = 60; most_arguments = 6
    # Modules with nothing to run: names of kinds; interfaces to the system; plain data.
    untested["base_kinds"]; untested["base_posix"]
    untested["deck_sweep"]; untested["sweep_keeper"]
    untested["export_drawing"]; untested["export_settings"]
    # Commands, proved by whole runs in tests/*.t, which see what their users see.
    untested["app_check"]; untested["app_help"]; untested["app_plot"]; untested["app_run"]
    untested["app_signals"]; untested["app_memory"]; untested["app_status"]; untested["app_input"]
    untested["app_run_conics"]; untested["app_run_body"]; untested["api_computed_body"]
    untested["app_export"]; untested["app_export_body"]; untested["app_export_conics"]; untested["app_export_parts"]
    untested["app_export_write"]
    untested["app_progress"]; untested["app_audit"]; untested["app_plot_audit"]
    untested["app_picture_drawing"]
    untested["app_progress"]
    untested["app_sweep"]; untested["app_sweep_result"]; untested["app_sweep_plot"]; untested["app_journal"]
    untested["app_plot_conics"]; untested["app_plot_body"]; untested["app_picture_folder"]
    # Faces for C, proved by tests/library.t from C.
    untested["api_c_error"]; untested["api_c_deck"]; untested["api_c_list"]
    untested["api_c_cut"]; untested["api_c_points"]; untested["api_c_measure"]; untested["api_c_table"]
    # Modules that may have variables: a signal handler takes no arguments of ours.
    has_variables["app_signals"]; has_variables["app_progress"]
}

function complain(words) { complain_at(FILENAME, FNR, words) }
function complain_at(file, line, words) {
    printf "%s:%d: %s\n", file, line, words
    faults++
}

# The code of a line in lower case: strings emptied, comment gone. `quote` holds an open string.
function code_of(text,    code, c, i) {
    for (i = 1; i <= length(text); i++) {
        c = substr(text, i, 1)
        if (quote != "") { if (c == quote) { quote = ""; code = code c } }
        else if (c == "!") break
        else { if (c == "'" || c == "\"") quote = c; code = code c }
    }
    if (quote != "" && text ~ /& *$/) return tolower(code) "&"
    quote = ""
    return tolower(code)
}

# --- one file -----------------------------------------------------------------------------------

function start_file() {
    file = FILENAME
    in_src = file ~ /^(src|mpi)\//
    layer = in_src ? layer_of(module_of(file)) : ""
    depth = units = implicit_none = is_private = documented = 0
    statement = quote = ""
    if (in_src && !(layer in below)) complain("src has no layer " layer)
}

function finish_file() {
    if (file == "") return
    if (units == 0) complain_at(file, 1, "holds no module and no program")
    if (!implicit_none) complain_at(file, 1, "has no `implicit none (type, external)`")
    if (is_module && !is_private) complain_at(file, 1, "has no `private` of its own")
    if (lines[module_of(file)] > longest_file)
        complain_at(file, longest_file + 1, "file is longer than " longest_file " lines")
}

# --- one statement ------------------------------------------------------------------------------

function inspect(s) {
    if (s ~ /^end *((module|program|subroutine|function|procedure|interface|type)( .*)?)?$/) close_unit(s)
    else if (s ~ /^module +[a-z][a-z0-9_]*$/) open_module(s)
    else if (s ~ /^program +[a-z]/) open_program(s)
    else if (s ~ /^(abstract +)?interface( |$)/) open_unit(s ~ /^abstract/ ? "abstract" : "interface")
    else if (s ~ /^type *(,[^:]*)?:: *[a-z]/ || s ~ /^type +[a-z][a-z0-9_]*$/) open_type()
    else if (is_procedure(s)) open_procedure(s)
    else {
        if (s ~ /^implicit none \(type, external\)$/) implicit_none = 1
        if (s == "private" && unit[depth] == "module") is_private = 1
        inspect_use(s)
        inspect_declaration(s)
        if (in_src) inspect_deed(s)
    }
}

function is_procedure(s) {
    return s ~ /^([a-z0-9_ ()*:,=]*[ )])?(subroutine|function) +[a-z][a-z0-9_]* *(\(|$)/
}

function open_unit(kind) {
    unit[++depth] = kind
    opened[depth] = start
}

function open_module(s) {
    is_module = 1
    open_file_unit("module")
    if (s != "module " module_of(FILENAME))
        complain("the path wants `module " module_of(FILENAME) "` here")
}

function open_program(s) {
    is_module = 0
    open_file_unit("program")
    if (!in_src && FILENAME !~ "/" substr(s, 9) "\\.f90$")
        complain("the program is not named as its file")
}

function open_file_unit(kind) {
    open_unit(kind)
    if (++units > 1) complain("more than one module or program in a file")
    if (!documented) complain(kind " without a `!>` docstring")
}

function open_type() {
    open_unit("type")
    if (in_src && !documented) complain("type without a `!>` docstring")
}

function open_procedure(s,    list) {
    if (in_src && !documented && (unit[depth] == "module" || depth == 0))
        complain("procedure without a `!>` docstring")
    list = s
    sub(/.*(subroutine|function) +[a-z][a-z0-9_]* *\(?/, "", list)
    sub(/\).*/, "", list)
    # An interface to foreign code has the arguments it has.
    if (unit[depth] != "interface" && gsub(/,/, "", list) + 1 > most_arguments)
        complain("more than " most_arguments " arguments")
    open_unit("procedure")
}

function close_unit(s) {
    if (unit[depth] ~ /module|program|procedure/ && s !~ /^end *[a-z]+ +[a-z]/)
        complain("`end` without what it ends and the name: `end subroutine name`")
    if (unit[depth] == "procedure" && FNR - opened[depth] + 1 > longest_procedure)
        complain("procedure is longer than " longest_procedure " lines")
    if (depth > 0) depth--
}

function inspect_use(s,    other) {
    if (s !~ /^use[ ,:]/) return
    if (s !~ /, *only *:/) complain("`use` without `only:`")
    other = used(s)
    if (other == "") return
    if (!(other in path)) complain("uses " other ", which is not in the tree")
    if (in_src && !may_use(layer, layer_of(other)))
        complain("layer " layer " may not use layer " layer_of(other))
}

# Variables of a module, and locals that keep their value because they are initialised.
function inspect_declaration(s,    names) {
    if (s ~ /^save( |$)/ || s ~ /^[a-z].*, *save *(,.*)?::/) complain("`save`: pass the value instead")
    if (s !~ /^(integer|real|logical|character|complex|type *\(|class *\(|procedure *\()/) return
    if (unit[depth] !~ /^(module|procedure)$/ || s ~ /^[^!]*, *parameter *(,.*)?::/) return
    if (unit[depth] == "module" && s !~ /^[a-z]* *=/ && !(module_of(FILENAME) in has_variables))
        complain("variable of a module: pass it as an argument")
    names = s
    if (unit[depth] == "procedure" && sub(/^.*::/, "", names) && names ~ /=/)
        complain("initialised local variable keeps its value between calls: assign it")
}

# Deeds that belong elsewhere: printing, stopping, opening; comparing a real exactly.
function inspect_deed(s,    number, begin) {
    number = "[-+]?([0-9]+\\.[0-9]*|[0-9]*\\.[0-9]+)([ed][-+]?[0-9]+)?(_[a-z0-9_]+)?"
    if (FILENAME != "src/base/exact.f90" && \
        (s ~ "([=/]=|\\.eq\\.|\\.ne\\.) *" number "([^a-z.]|$)" || \
         s ~ "(^|[^a-z0-9_])" number " *([=/]=|\\.eq\\.|\\.ne\\.)"))
        complain("exact comparison of reals: use is_zero or is_equal of base_exact")
    if (layer == "app") return
    begin = "(^|\\) *)"    # a statement begins its line or follows `if (...)`
    if (s ~ begin "print( |\\*|'|$)") complain("`print` outside src/app")
    if (s ~ begin "write *\\( *(\\*|[0-9]|unit *=|[a-z_]*_unit *[,)])")
        complain("writes to a unit outside src/app")
    if (s ~ begin "(error +)?stop( |,|$)") complain("`stop` outside src/app")
    if (s ~ begin "open *\\(") complain("`open` outside src/app")
}

# --- one line -----------------------------------------------------------------------------------

FNR == 1 { finish_file(); start_file() }

# FORD takes `word:` at the beginning of a docstring for a setting, and drops the line.
in_src && key_at && (key_is_above || /^ *!!/) {
    complain_at(FILENAME, key_at, "docstring that begins with `word:`, which FORD drops")
}
{ key_at = 0 }
/^ *!>/ ? !was_above && /!> *[A-Za-z0-9_-]+:( |$)/ : !/^ *!/ && /!! *[A-Za-z0-9_-]+:( |$)/ {
    key_at = FNR; key_is_above = /^ *!>/
}
{ was_above = /^ *!>/ }

/\t/               { complain("tab") }
/[ \r]$/           { complain("blank at the end of the line") }
length($0) > widest { complain("line is wider than " widest " columns") }
/^ *!>/            { documented = 1 }

# The meaning of an argument stands on the line of its declaration, or on a line of its own below.
wants_meaning && statement == "" && !/^ *!!/ {
    complain_at(FILENAME, wants_meaning, "argument without a `!!` meaning")
    wants_meaning = 0
}
in_src && /, *(intent *\(|value *::)/ { wants_meaning = FNR }
/!!/ { wants_meaning = 0 }

{
    code = code_of($0)
    if (statement == "") start = FNR
    else if (code ~ /^ *$/) next
    sub(/^ *&?/, "", code)
    statement = statement code
    if (sub(/& *$/, "", statement)) next
    sub(/ +$/, "", statement)
    if (statement != "") inspect(statement)
    if (statement != "" || $0 ~ /^ *$/) documented = 0
    statement = ""
}

END {
    FNR = 0
    finish_file()
    for (i = 1; i < ARGC; i++) {
        m = module_of(ARGV[i])
        if (ARGV[i] !~ /^src\// || m in untested || m in is_program) continue
        proof = ARGV[i]
        sub(/^src\//, "tests/", proof)
        sub(/[^\/]*$/, "test_&", proof)
        if (!(module_of(proof) in path)) complain_at(ARGV[i], 1, "has no test " proof)
    }
    print "lint: " faults + 0 (faults == 1 ? " fault" : " faults")
    exit faults > 0
}
