!> The library as a Fortran program uses it: all from one module; many threads at once.
program test_loft
    use api_loft, only: at_buttock, at_plane, at_station, at_waterline, asked_type, &
        body_measure_type, cause, conic_table, cut_deck, cut_kind, cut_type, deck_type, &
        duct_measure_type, duct_section_type, error_type, has_errors, listed_cut, load_deck, &
        loft_version, measure_deck, measure_duct, measure_duct_station, measure_station, &
        parse_deck, row_type, section_measure_type
    use base_constants, only: version
    use base_kinds, only: dp
    use support_book, only: text_file
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(deck_type) :: deck, parsed
    type(cut_type) :: cut, other
    type(error_type), allocatable :: error
    type(row_type), allocatable :: rows(:)

    call tap%same(loft_version(), version, 'the library has the version of the program')
    call load_deck('cards/none.crd', deck, error)
    call tap%ok(allocated(error), 'a deck that is not there is an error')
    if (allocated(error)) call tap%same(error%message, &
        'cards/none.crd: No such file or directory', 'in the system''s words')
    call load_deck('cards/nose.crd', deck, error)
    call tap%ok(.not. allocated(error) .and. .not. has_errors(deck), 'the nose is loaded')
    call parse_deck(text_file('cards/nose.crd'), parsed)
    call tap%ok(size(parsed%cuts) == size(deck%cuts) .and. size(deck%cuts) > 5, &
        'the same deck from memory asks for the same cuts')
    call cut_deck(deck, at_station(20.0_dp), cut, error)
    call cut_deck(deck, at_plane([20.0_dp, 1.0_dp, 2.0_dp], [4.0_dp, 0.0_dp, 0.0_dp]), other, error)
    call tap%ok(size(cut%points) == 25 .and. all(cut%points%at(1) <= 20.0_dp), 'a station is cut')
    call tap%ok(maxval(abs(pack(cut%points%at(3) - other%points%at(3), .true.))) < 1.0e-12_dp, &
        'as the plane across it is')
    call cut_deck(deck, at_buttock(4.5_dp), cut, error)
    call tap%ok(cut%kind == cut_kind%buttock .and. all(abs(cut%points%at(2) - 4.5_dp) <= 0.0_dp), &
        'a butt line is cut')
    call cut_deck(deck, at_waterline(-16.0_dp), cut, error)
    call tap%ok(all(abs(cut%points%at(3) + 16.0_dp) <= 0.0_dp), 'a waterline is cut')
    call listed_cut(deck, 1, cut, error)
    call tap%ok(abs(cut%points(1)%at(1)) <= 0.0_dp, 'the first cut of the deck is at station 0')
    call check_measures()
    call load_deck('cards/sae700202.crd', deck, error)
    call conic_table(deck, 1, 1, rows, error)
    call tap%ok(size(rows) == 17, 'the first card of 1970 has seventeen rows by X')
    call tap%near(rows(2)%y, -9.443_dp, 5.0e-4_dp, 'the second as the book prints it')
    call conic_table(deck, 1, 2, rows, error)
    call tap%ok(size(rows) == 0 .and. .not. allocated(error), 'and none by Y')
    call conic_table(deck, 12, 1, rows, error)
    call tap%ok(allocated(error), 'there is no twelfth card')
    call check_ducts()
    call check_threads()
    call tap%finish()

contains

    !> Volume and sections of an ellipsoid stand to its wetted area as they must.
    subroutine check_measures()
        type(deck_type) :: sphere
        type(body_measure_type) :: whole
        type(section_measure_type) :: middle
        real(dp), parameter :: pi = acos(-1.0_dp)
        real(dp) :: radius

        call load_deck('cards/sphere.crd', sphere, error)
        call measure_deck(sphere, 1, whole, error)
        radius = 0.5_dp*(whole%to - whole%from)
        call tap%near(whole%volume, 4.0_dp/3.0_dp*pi*radius**3, 1.0e-9_dp*radius**3, &
            'a sphere has its volume')
        call measure_station(sphere, 1, 0.5_dp*(whole%from + whole%to), middle, error)
        call tap%near(middle%area, pi*radius**2, 1.0e-9_dp*radius**2, 'and its section')
        call measure_station(sphere, 2, 0.0_dp, middle, error)
        call tap%ok(allocated(error), 'a body that is not there has none')
        if (allocated(error)) call tap%ok(error%cause == cause%usage, 'which is its cause')
        call measure_deck(sphere, 0, whole, error)
        call tap%ok(allocated(error), 'nor a volume')
    end subroutine check_measures

    !> A duct has at its outlines the areas of their cards, and a volume near Simpson's of its area
    !> curve.
    subroutine check_ducts()
        type(deck_type) :: inlet
        type(duct_measure_type) :: whole
        type(duct_section_type) :: section
        integer, parameter :: parts = 200
        real(dp) :: simpson
        integer :: i

        call load_deck('cards/duct.crd', inlet, error)
        call measure_duct(inlet, 1, 1, whole, error)
        call tap%near(maxval(abs(whole%section%area - [1.18_dp, 1.1_dp, 1.22_dp, 1.36_dp])), &
            0.0_dp, 1.0e-9_dp, 'the outlines of a duct have the areas of their cards')
        simpson = 0.0_dp
        do i = 0, parts
            call measure_duct_station(inlet, 1, 1, 6.5_dp*real(i, dp)/real(parts, dp), section, &
                error)
            simpson = simpson + 6.5_dp/real(3*parts, dp)*section%area* &
                real(merge(1, merge(2, 4, mod(i, 2) == 0), i == 0 .or. i == parts), dp)
        end do
        call tap%near(whole%volume, simpson, 1.0e-6_dp, 'its volume is that under its area curve')
        call measure_duct_station(inlet, 1, 1, -0.1_dp, section, error)
        call tap%ok(allocated(error), 'before its lip it has no section')
        if (allocated(error)) call tap%ok(error%cause == cause%beyond_lines, 'which is its cause')
        call measure_duct(inlet, 1, 0, whole, error)
        call tap%ok(allocated(error), 'a duct that is not there has no volume')
    end subroutine check_ducts

    !> Threads that share a deck, or load their own, and fail between, get what one thread gets.
    subroutine check_threads()
        type(deck_type) :: nose, book, own
        type(cut_type) :: made
        type(section_measure_type) :: section, middle
        type(error_type), allocatable :: trouble
        integer :: lengths(11), wrong, i

        call load_deck('cards/nose.crd', nose, error)
        call load_deck('cards/sae700202.crd', book, error)
        call cut_deck(nose, at_station(10.0_dp), cut, error)
        call measure_station(nose, 1, 10.0_dp, middle, error)
        do i = 1, size(lengths)
            call conic_table(book, i, 1, rows, error)
            lengths(i) = size(rows)
        end do
        wrong = 0
        !$omp parallel do num_threads(8) reduction(+: wrong) &
        !$omp private(own, made, trouble, section, rows)
        do i = 1, 400
            call cut_deck(nose, at_station(10.0_dp), made, trouble)
            if (any(abs(made%points%at(3) - cut%points%at(3)) > 0.0_dp)) wrong = wrong + 1
            call cut_deck(nose, at_station(-10.0_dp**mod(i, 9) - 31.0_dp), made, trouble)
            if (index(trouble%message, 'beyond line') == 0) wrong = wrong + 1
            call parse_deck('LINE    X       SIDE'//new_line('a')//'0.,0.,1.,A', own)
            if (.not. has_errors(own)) wrong = wrong + 1
            call measure_station(nose, 1, 10.0_dp, section, trouble)
            if (abs(section%girth - middle%girth) > 0.0_dp) wrong = wrong + 1
            call conic_table(book, 1 + mod(i, 11), 1, rows, trouble)
            if (allocated(trouble) .or. size(rows) /= lengths(1 + mod(i, 11))) wrong = wrong + 1
        end do
        !$omp end parallel do
        call tap%ok(wrong == 0, 'eight threads get what one gets')
    end subroutine check_threads

end program test_loft
