#!/bin/sh
# Breaks every rule of lint.awk once, in a small tree of its own, and asks for that complaint and no
# other; the tree unbroken is let pass.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
rules="$PWD/tests/make/modules.awk $PWD/tests/lint/lint.awk"
tree=$(mktemp -d) && trap 'rm -rf "$tree"' EXIT
cd "$tree" || exit 1
mkdir -p src/base src/geom src/deck src/app tests/base tests/geom tests/deck tests/app

# A module and its test, both without fault: whole LAYER NAME.
whole() {
    cat > "src/$1/$2.f90" <<END
!> What is here.
module $1_$2
    use, intrinsic :: iso_fortran_env, only: real64
    implicit none (type, external)
    private

    public :: deed, thing_type

    !> One constant.
    real(real64), parameter :: one = 1.0_real64

    !> One type.
    type :: thing_type
        integer :: size = 0
    end type thing_type

    interface
        subroutine foreign(a, b, c, d, e, f, g)
            integer, intent(in) :: a, b, c, d, e, f, g !! what it takes
        end subroutine foreign
    end interface

contains

    !> One deed: tells "end", 'stop' and print apart from words.
    pure subroutine deed(thing, &
        ! a remark between
        text)
        type(thing_type), intent(in) :: thing !! the thing
        character(*), intent(inout) :: text   !! its name
        if (thing%size > 0) write (text, '(a, f3.1)') 'stop; print *, "open(1) == 1.0', one
    end subroutine deed

end module $1_$2
END
    cat > "tests/$1/test_$2.f90" <<END
!> Tests it.
program test_$2
    use $1_$2, only: deed
    implicit none (type, external)
    integer :: count = 0
    print '(i0)', count
    stop 1, quiet=.true.
end program test_$2
END
}

lint() { awk $(printf -- '-f %s ' $rules) $(find src tests -name '*.f90' | sort); }

# Breaks the module: faulty 'NAME' 'COMPLAINT' 'SED COMMANDS' [FILE].
faulty() {
    file=${4:-src/geom/arc.f90}
    cp "$file" kept
    sed "$3" kept > "$file"
    said=$(lint)
    status=$?
    [ $status = 1 ] && [ "$(echo "$said" | wc -l)" = 2 ] &&
        echo "$said" | head -n 1 | grep -q "^$file:[0-9]*: .*$2"
    ok $? "$1" "$said"
    mv kept "$file"
}
# A statement more at the start of the deed.
deed() { faulty "$1" "$2" "/text   !! its name/a\\        $3" "$4"; }

whole base text; whole geom arc; whole deck card; whole app signals
said=$(lint); ok $? 'a tree without fault is let pass' "$said"

tab=$(printf '\t')
wide=$(printf '%0101d' 0)
yes '        thing%size = 1' | head -n 60 > many
yes '!' | head -n 300 > long

deed   'a tab'                            'tab'                 "if (.true.)${tab}return"
deed   'a blank at the end of a line'     'blank at the end'    'if (.true.) return '
deed   'a line too wide'                  'wider than 100'      "! $wide"
faulty 'a file too long'                  'longer than 300'     '/^end module/r long'
faulty 'a procedure too long'             'longer than 60'      '/text   !! its name/r many'
faulty 'too many arguments'               'more than 6 arg'     's/^        text)/        text, b, c, d, e, f)/'
faulty 'a module not named as its path'   'wants .module geom_arc' 's/module geom_arc/module geom_bow/'
faulty 'a program not named as its file'  'not named as its file'  's/program test_arc/program arc/' tests/geom/test_arc.f90
faulty 'two modules in a file'            'more than one module'   '1i\!> Another.\
program other\
end program other'
faulty 'neither module nor program'       'holds no module'     's/^.*$//; 1s/.*/implicit none (type, external)/' tests/geom/test_arc.f90
faulty 'implicit typing'                  'implicit none'       's/implicit none.*/implicit none/'
faulty 'a module that hides nothing'      'private'             's/^    private$//'
faulty 'a use without only'               'without .only:'      's/^    use, .*/    use, intrinsic :: iso_fortran_env/'
faulty 'a module that is not there'       'not in the tree'     's/^    private$/    use geom_bow, only: x\
&/'
faulty 'a layer that uses one above'      'geom may not use layer app'  's/^    private$/    use app_signals, only: x\
&/'
faulty 'a layer that uses a sibling'      'geom may not use layer deck' 's/^    private$/    use deck_card, only: x\
&/'
faulty 'base that uses anything'          'base may not use layer geom' 's/^    private$/    use geom_arc, only: x\
&/' src/base/text.f90
faulty 'a variable of a module'           'variable of a module' 's/^    !> One constant/    integer :: n\
&/'
faulty 'a variable of a module, old form' 'variable of a module' 's/^    !> One constant/    real x\
&/'
faulty 'a saved variable'                 'save'                's/^    !> One constant/    save\
&/'
deed   'an initialised local variable'    'initialised local'   'integer :: n = 0'
faulty 'an end without name'              'end subroutine name' 's/end subroutine deed/end subroutine/'
faulty 'a bare end'                       'end subroutine name' 's/end subroutine deed/end/'
faulty 'a module without docstring'       'module without a'    '1d'
faulty 'a type without docstring'         'type without a'      's/!> One type/! One type/'
faulty 'a procedure without docstring'    'procedure without a' 's/!> One deed/! One deed/'
faulty 'an argument without meaning'      'argument without a'  's/!! the thing//; s/thing *$/thing/'
faulty 'a docstring that begins as a setting' 'FORD drops'    's/!> One deed: /!> Deed: /'
faulty 'a meaning that begins as one'     'FORD drops'          's/!! its name/!! 1: its name, and\
                                                               !! more/'
deed   'an exact comparison'              'exact comparison'    'if (x == 0.0_dp) return'
deed   'an exact comparison, the number first'   'exact comparison' 'if (1.5_dp /= x) return'
deed   'an exact comparison, by letters'  'exact comparison'    'if (x .eq. -.5e1) return'
deed   'a print statement'                'print. outside'      "print *, 'x'"
deed   'a print statement under if'       'print. outside'      "if (a(1) > 0) print *, 'x'"
deed   'a write to any unit'              'writes to a unit'    "write (*, *) 'x'"
deed   'a write to standard error'        'writes to a unit'    "write (error_unit, '(a)') 'x'"
deed   'a write to a number'              'writes to a unit'    "if (a(1) > 0) write (6, '(a)') 'x'"
deed   'a stop'                           'stop. outside'       'stop 1'
deed   'an error stop under if'           'stop. outside'       "if (a(1) > 0) error stop 'x'"
deed   'an opened file'                   'open. outside'       'open (newunit=n, file=name)'

sed 's/geom_arc/geom_bow/' src/geom/arc.f90 > src/geom/bow.f90
said=$(lint); [ $? = 1 ] && [ "$said" = "src/geom/bow.f90:1: has no test tests/geom/test_bow.f90
lint: 1 fault" ]
ok $? 'a module without test' "$said"
rm src/geom/bow.f90
mkdir -p src/hull tests/hull; whole hull rib
said=$(lint); [ $? = 1 ] && echo "$said" | grep -q '^src/hull/rib.f90:1: src has no layer hull'
ok $? 'a layer that is not in the table' "$said"
rm -r src/hull tests/hull

sed -i.kept "s/        if (thing.*/        stop 1/" src/app/signals.f90 && rm src/app/signals.f90.kept
said=$(lint); ok $? 'app may stop' "$said"

finish
