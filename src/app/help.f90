!> What `loft help` says.
module app_help
    use base_constants, only: version
    use base_error, only: cause, error_type, fail
    use base_output, only: output_type
    use base_text, only: upper
    use report_card_reference, only: print_card, print_card_reference
    implicit none (type, external)
    private

    public :: print_help, print_version

contains

    !> Prints the help on a topic; without one, the overview.
    !>
    !> Fails with `cause%usage` where there is no such topic.
    subroutine print_help(topic, out, error)
        character(*), intent(in) :: topic                   !! a command, `cards`, the word of a
                                                            !! card, or nothing
        type(output_type), intent(inout) :: out             !! where it goes
        type(error_type), allocatable, intent(out) :: error !! see above
        logical :: is_card

        select case (topic)
        case ('')
            call print_overview(out)
        case ('run')
            call print_run(out)
        case ('check')
            call print_check(out)
        case ('plot')
            call print_plot(out)
        case ('export')
            call print_export(out)
        case ('audit')
            call print_audit(out)
        case ('sweep')
            call print_sweep(out)
        case ('cards')
            call print_card_reference(out)
        case ('help')
            call out%lines([character(80) :: 'loft help [TOPIC]', '', &
                'TOPIC is run, check, plot, export, audit, sweep, cards, or the word that a card', &
                'begins with, as STATION; CONIC is the card of 1970. None is the overview.'])
        case default
            call print_card(upper(topic), out, is_card)
            if (.not. is_card) call fail(error, cause%usage, 'no help on '''//topic// &
                '''; topics: run check plot export audit sweep cards, or a card, as STATION')
        end select
    end subroutine print_help

    !> Prints the name and version.
    subroutine print_version(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%line('loft '//version)
    end subroutine print_version

    !> Prints what LOFT is and its commands.
    subroutine print_overview(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%lines([character(80) :: &
            'LOFT computes conic lofts of aircraft bodies from decks of card images.', '', &
            '  loft run [OPTIONS] [DECK]      tables of ordinates', &
            '  loft check DECK...             only reads, prints every diagnostic', &
            '  loft plot [OPTIONS] DECK       pictures, by gnuplot', &
            '  loft export [OPTIONS] DECK     patterns, CAD files, meshes, NC programs', &
            '  loft audit [OPTIONS] DECK      printed tables back to their lines', &
            '  loft sweep [OPTIONS] DECK      many variants, the best of them', &
            '  loft help [TOPIC]              a command, cards, or one card, as STATION', &
            '  loft --version', '', &
            'A DECK of - is standard input; run reads it too where no deck is named.', '', &
            'Exit status: 0 all done; 1 some card was in error, the others ran; 2 the', &
            'command line is wrong, or a file can''t be read or written.'])
    end subroutine print_overview

    !> Prints the help on `loft run`.
    subroutine print_run(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%lines([character(80) :: &
            'loft run [--arithmetic ieee|s360] [--shift N] [--asa] [--format listing|csv]', &
            '         [-o FILE] [DECK]', '', &
            'Runs a deck and prints its tables.', '', &
            '  --arithmetic ieee    the conic as an arc, good to a few units in the last', &
            '                       place; only the contour is printed (the default)', &
            '  --arithmetic s360    the 1970 program in System/360 arithmetic: its page,', &
            '                       figure for figure, both roots of every ordinate', &
            '  --shift N            what the 1970 program adds to every X and Y before it', &
            '                       solves; deck units, default 100. Of the ieee listing', &
            '                       it moves only the coefficients in the book''s frame', &
            '  --asa                with s360: keep the carriage control column; without', &
            '                       it a new page is a form feed', &
            '  --format listing     printer-style pages (the default)', &
            '  --format csv         full precision; header card,axis,x,y,slope,curvature,', &
            '                       of a body deck cut,kind,section,sta,bl,wl,slope,', &
            '                       curvature,bevel', &
            '  -o FILE              write FILE, complete or not at all', '', &
            'Diagnostics go to standard error with file, line, columns and card.'])
    end subroutine print_run

    !> Prints the help on `loft check`.
    subroutine print_check(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%lines([character(80) :: &
            'loft check DECK...', '', &
            'Reads decks and prints every diagnostic on standard error, and nothing else.', &
            'It also warns of what run takes as punched: a number without a point has', &
            'implied decimals, a blank behind a figure is a zero.', &
            'Exit status 1 where there is an error; warnings leave it 0.'])
    end subroutine print_check

    !> Prints the help on `loft plot`.
    subroutine print_plot(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%lines([character(80) :: &
            'loft plot [-o DIR] [--format svg|pdf|png|txt] DECK', '', &
            'Draws the conics of a deck with their three points and end tangents.', &
            'The comment right before a card names it. A name with the word SIDE, PLAN,', &
            'or STA, STATION or SECTION puts it in that picture; other cards share one.', '', &
            'Of a body deck it draws the lines plan, curvature combs, the area curve, each', &
            'cut in true shape, and a view in space.', '', &
            '  -o DIR          folder for pictures, data and gnuplot scripts; made where', &
            '                  there is none. Default: the name of the deck and -plots', &
            '  --format F      svg (the default), pdf, png, or txt for a terminal', '', &
            'Without gnuplot the data and scripts are written all the same.'])
    end subroutine print_plot

    !> Prints the help on `loft sweep`.
    subroutine print_sweep(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%lines([character(80) :: &
            'loft sweep [-o FILE] [--resume] [--plot] [--variant N] DECK', '', &
            'Computes the variants that SWEEP and VARY cards of a body deck make, measures', &
            'what its OBJECT and LIMIT cards name, and prints one row each as CSV: variant,', &
            'variables, measures, state (ok, limit or fault), front (1 on the Pareto front),', &
            'why. A summary with the front and the best variant follows.', '', &
            '  -o FILE         rows go to FILE, the deck of the best to FILE.best.crd, the', &
            '                  summary to standard output. While it runs, what is finished', &
            '                  stands in FILE.partial', &
            '  --resume        goes on with a sweep that was stopped, however that was', &
            '  --plot          draws all variants and the front, by gnuplot', &
            '  --variant N     prints the deck of variant N, to FILE with -o; nothing else', &
            '', &
            'It uses all cores; OMP_NUM_THREADS says how many. Over many machines:', &
            '    mpirun -n N loft-mpi sweep DECK -o FILE', &
            'The result is the same, byte for byte. Exit status 1 where a card is in error or', &
            'no variant keeps all limits.'])
    end subroutine print_sweep

    !> Prints the help on `loft audit`.
    subroutine print_audit(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%lines([character(80) :: &
            'loft audit [--format listing|csv|deck] [-o FILE] DECK', '', &
            'Finds out which figures of printed tables are right, what the others should', &
            'be, and what line they came from. The deck begins with an AUDIT card:', '', &
            '  AUDIT   LSH     PLAN                          BL of line LSH over STA', &
            '  EXACT   X1      -30.    Y1      0.0     S1      0.404   as punched', &
            '  EXACT   X3      50.     Y3      18.2', &
            '  ABOUT   S3      0.132                         rounded to its decimals', &
            '  0.      9.000   5.      10.167  10.     11.2?1  15.     12.379', &
            '  20.     13.312  25.     14.253  30.     15.144', '', &
            'A ? is a character that can''t be read. The same can be given as CSV with the', &
            'header table,view,at,what,along,printed.', '', &
            '  --format listing   each figure with what the line gives, how far it is off', &
            '                     in units of its last place, the verdict, the corrected', &
            '                     figure and the slip that explains it (the default)', &
            '  --format csv       the same, a row a figure; it can be audited again', &
            '  --format deck      the cards that reproduce the tables, for loft run', &
            '  -o FILE            write FILE, complete or not at all', '', &
            'loft plot DECK draws what the figures are off. Suspect figures leave the exit', &
            'status 0; a faulty card makes it 1.'])
    end subroutine print_audit

    !> Prints the help on `loft export`.
    subroutine print_export(out)
        type(output_type), intent(inout) :: out !! where it goes
        call out%lines([character(80) :: &
            'loft export DECK -o FILE [OPTIONS]', '', &
            'Writes the cuts, lines and bodies of a deck as a file, by its ending:', '', &
            '  .svg .pdf         patterns of the cuts at full size', &
            '  .dxf              the cuts as polylines, splines or arcs', &
            '  .igs .iges        curves, lines and skin; .step .stp: the same, as a solid', &
            '                    where the body is closed', &
            '  .stl .obj         the skin as triangles', &
            '  .nc .ngc .gcode   the cuts as a program of G-code', &
            '  .hrm .wgs .csv    sections for OpenVSP, LaWGS (PANAIR) and CPACS', '', &
            'FILE.receipt says, and standard output shows, what each entity is, exact or', &
            'not, its largest error and where, the units and the checksum of the deck.', '', &
            '  -o FILE           the file; - is standard output, --format says what goes', &
            '                    there: svg pdf dxf iges step stl obj nc hrm wgs csv', &
            '  --tolerance T     how far a file may be from the exact shape, in deck units;', &
            '                    .001 in, .025 mm or .00008 ft where it is not said,', &
            '                    ten times as much for stl and obj', &
            '  --units U         of the file: in, mm, ft or m; else those of the deck', &
            '                    (nc of feet: in; csv: always m)', &
            '  --cut LIST        only these cuts, by number or name; may stand several times'])
        call out%lines([character(80) :: &
            'Patterns', &
            '  --sheet each|all  a sheet (pdf: page, svg: file) for each cut, or one for all', &
            '  --paper P         tiles of a4, letter, a3, tabloid, or roll WIDTH', &
            '  --overlap W       of tiles, in units of the file; .5 in or 12 mm', &
            '  --half            symmetric cuts as their half (also dxf, nc)', &
            '  --bevel STEP      from bevel mark to mark, deck units; 6 in or 150 mm (also', &
            '                    dxf)', &
            'DXF, IGES, STEP', &
            '  --dxf-splines     R2000 with rational splines, not R12 with polylines', &
            '  --3d              DXF: cuts and lines where they are in space', &
            '  --arcs            circular arcs for all cuts, within --tolerance (dxf, nc);', &
            '                    without it where the deck has an ARCS card, within its own', &
            '  --iges-conics     IGES: conics as entity 104 where they are conics', &
            '  --open            no caps, no solid (also stl, obj)', &
            'Meshes', &
            '  --angle DEG       largest turn between triangles; 10 (also hrm, wgs, csv)', &
            '  --binary          binary STL', &
            'NC, in units of the file', &
            '  --feed F          along the cut, a minute; 20 in or 500 mm', &
            '  --depth Z         of the cut, below 0; -.125 in or -3 mm', &
            '  --safe Z          above everything; .25 in or 6 mm'])
    end subroutine print_export

end module app_help
