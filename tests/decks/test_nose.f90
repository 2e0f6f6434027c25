!> `cards/nose.crd`, the nose of SAE 700202 from Table 1 alone, against every figure of Table 4.
program test_nose
    use api_computed_body, only: computed_body_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use cut_outline, only: cut_type
    use support_book, only: figure_type, read_figures
    use support_book_nose, only: is_of_nose, nose_of_deck, off_nose, point_of
    use support_computed, only: computed_deck
    use support_tap, only: tap_type
    implicit none (type, external)

    !> What the paper's rounding between its two steps may come to, normal to the skin; and the
    !> largest difference along an ordinate, which stands at station 10, BL 13.5.
    real(dp), parameter :: allowed = 0.004_dp, largest_ordinate = 0.0098_dp
    !> Half of the last figure printed.
    real(dp), parameter :: half_figure = 0.0005_dp
    type(tap_type) :: tap
    type(body_type) :: nose
    type(computed_body_type) :: it

    call nose_of_deck(nose)
    call computed_deck(tap, 'nose', it)
    call prove_figures()
    call prove_cuts()
    call tap%finish()

contains

    !> Every figure lies next to the surface, and somewhere not on it: it was rounded.
    subroutine prove_figures()
        type(figure_type), allocatable :: figures(:)
        real(dp) :: distance, worst
        integer :: i

        allocate (figures(0))
        figures = read_figures('golden/book/tables.csv')
        figures = pack(figures, is_of_nose(figures))
        call tap%ok(size(figures) == 26, 'Table 4 has 26 figures')
        worst = 0.0_dp
        do i = 1, size(figures)
            call off_nose(nose, point_of(figures(i)), distance)
            call tap%near(distance, 0.0_dp, allowed, trim(figures(i)%line)//', '// &
                figures(i)%axis//' '//trim(figures(i)%along)//': within .004 in of the skin')
            worst = max(worst, abs(distance))
        end do
        call tap%ok(worst > half_figure, 'the book is further off than its last figure rounds')
    end subroutine prove_figures

    !> The cuts are those of the book: frames, floor, longitudinal and oblique frame.
    subroutine prove_cuts()
        call tap%ok(size(it%cuts) == 10, 'seven frames, floor, longitudinal and oblique frame')
        call near_book(it%cuts(9), 9, [10.0_dp, 4.5_dp, -19.467_dp], 'frame BL 4.5 at station 10')
        call near_book(it%cuts(9), 9, [20.0_dp, 4.5_dp, -20.889_dp], 'frame BL 4.5 at station 20')
        call near_book(it%cuts(8), 8, [10.0_dp, 12.557_dp, -16.0_dp], 'floor at station 10')
        call near_book(it%cuts(8), 8, [20.0_dp, 15.211_dp, -16.0_dp], 'floor at station 20')
        call near_book(it%cuts(10), 10, [25.0_dp, 17.296_dp, -11.0_dp], 'oblique frame, station 25')
        call near_book(it%cuts(10), 10, [30.0_dp, 18.387_dp, -6.0_dp], 'oblique frame, station 30')
    end subroutine prove_cuts

    !> A cut has a point next to one of the book.
    subroutine near_book(cut, number, at, name)
        type(cut_type), intent(in) :: cut       !! of the deck
        integer, intent(in) :: number           !! which, for the note
        real(dp), intent(in) :: at(3)           !! STA, BL, WL, inches
        character(*), intent(in) :: name        !! of the check
        real(dp) :: nearest
        integer :: k

        nearest = huge(1.0_dp)
        associate (points => cut%outlines(1)%points)
            do k = 1, size(points)
                nearest = min(nearest, norm2(points(k)%at - at))
            end do
        end associate
        call tap%ok(nearest <= largest_ordinate .and. number > 0, name)
    end subroutine near_book

end program test_nose
