!> The library as a Fortran program uses it: all from one module; many threads at once.
program test_loft
    use api_loft, only: at_buttock, at_plane, at_station, at_waterline, asked_type, &
        body_measure_type, cause, conic_table, cut_deck, cut_kind, cut_type, deck_type, &
        error_type, has_errors, listed_cut, load_deck, loft_version, measure_deck, &
        measure_station, parse_deck, row_type, section_measure_type
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

    !> Threads that share a deck, or load their own, and fail between, get what one thread gets.
    subroutine check_threads()
        type(deck_type) :: nose, own
        type(cut_type) :: made
        type(error_type), allocatable :: trouble
        integer :: wrong, i

        call load_deck('cards/nose.crd', nose, error)
        call cut_deck(nose, at_station(10.0_dp), cut, error)
        wrong = 0
        !$omp parallel do num_threads(8) private(own, made, trouble) reduction(+: wrong)
        do i = 1, 400
            call cut_deck(nose, at_station(10.0_dp), made, trouble)
            if (any(abs(made%points%at(3) - cut%points%at(3)) > 0.0_dp)) wrong = wrong + 1
            call cut_deck(nose, at_station(-10.0_dp**mod(i, 9) - 31.0_dp), made, trouble)
            if (index(trouble%message, 'beyond line') == 0) wrong = wrong + 1
            call parse_deck('LINE    X       SIDE'//new_line('a')//'0.,0.,1.,A', own)
            if (.not. has_errors(own)) wrong = wrong + 1
        end do
        !$omp end parallel do
        call tap%ok(wrong == 0, 'eight threads get what one gets')
    end subroutine check_threads

end program test_loft
