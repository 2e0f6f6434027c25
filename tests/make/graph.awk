# The modules as a picture, in the language of graphviz: one band a layer, one box a module with its
# lines, an arrow to each module used. Arrows that other arrows imply are left out; those against the
# layers are red and always drawn.
#     awk -f modules.awk -f graph.awk FILE... | dot -Tsvg

# True where an arrow says nothing new: the module used is also needed by another one used.
function is_implied(module, other,    name, n, i, needs) {
    n = split(uses[module], name)
    for (i = 1; i <= n; i++) {
        if (name[i] == other) continue
        split("", needs)
        mark_needs(name[i], needs)
        if (other in needs) return 1
    }
    return 0
}

# Grey for what everybody uses, black inside a band, else a colour for each band the arrow leaves.
function colour_of(module, other) {
    if (layer_of(module) == layer_of(other)) return "#444444"
    if (layer_of(other) == layer_at[1]) return "#c4c4c4"
    return ink[1 + index(layers, layer_of(module)) % inks]
}

function draw_arrows(module,    name, n, i, drawn) {
    n = split(uses[module], name)
    for (i = 1; i <= n; i++) {
        if (name[i] in drawn) continue
        drawn[name[i]]
        if (!may_use(layer_of(module), layer_of(name[i])))
            print "    " module " -> " name[i] " [color=red, penwidth=2.5, constraint=false]"
        else if (!is_implied(module, name[i]))
            print "    " module " -> " name[i] " [color=\"" colour_of(module, name[i]) "\"]"
    }
}

# A band, and marks above and below it that keep the bands apart and in order.
function draw_band(layer, above,    i, m, label) {
    print "    subgraph cluster_" layer " {"
    print "        label=\"" layer "\"; bgcolor=\"" paper[1 + bands++ % 2] "\""
    print "        " layer "_top, " layer "_foot [style=invis, shape=point, height=0, width=0]"
    for (i = 1; i < ARGC; i++) {
        m = module_of(ARGV[i])
        if (layer_of(m) != layer) continue
        label = m
        sub(/^[^_]*_/, "", label)
        print "        " m " [label=\"" label "\\n" lines[m] "\"]"
        print "        " layer "_top -> " m " -> " layer "_foot [style=invis, weight=0]"
    }
    print "    }"
    if (above != "") print "    " above "_foot -> " layer "_top [style=invis, weight=100]"
}

END {
    split("#f3f0e6 #e6eef3", paper)
    inks = split("#1f77b4 #d98200 #2a8c3c #8a4fb0 #8c564b", ink)
    print "digraph loft {"
    print "    graph [fontname=Helvetica, fontsize=20, labeljust=l, color=\"#cccccc\", style=rounded]"
    print "    graph [nodesep=.12, ranksep=.3]"
    # So many rounds of straightening for each box, or dot takes many minutes.
    print "    graph [nslimit=2, nslimit1=2]"
    print "    node [fontname=Helvetica, fontsize=12, shape=box, style=filled, fillcolor=white, height=.4]"
    print "    edge [arrowsize=.6]"
    n = split(layers, layer_at)
    for (k = n; k > 0; k--) {
        for (m in path) if (layer_of(m) == layer_at[k]) break
        if (layer_of(m) != layer_at[k]) continue
        draw_band(layer_at[k], above)
        above = layer_at[k]
    }
    for (i = 1; i < ARGC; i++) draw_arrows(module_of(ARGV[i]))
    print "}"
}
