!> Tests of the sheet of combs.
program test_body_combs
    use base_kinds, only: dp
    use export_body_combs, only: combs_drawing
    use export_body_drawing, only: drawing_type
    use support_solids, only: cylinder, ellipsoid
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(drawing_type) :: drawing
    character(:), allocatable :: words
    integer :: i

    drawing = combs_drawing(ellipsoid([5.0_dp, 3.0_dp, 2.0_dp]), 'EGG', 'inches')
    words = ''
    do i = 1, drawing%count
        words = words//'|'//drawing%words(i)%text
    end do
    call tap%ok(index(words, '|TOP side|') > 0 .and. index(words, '|USH plan|') > 0, &
        'each view of a line has its name')
    call tap%ok(index(words, '|MHB side|') == 0, 'a constant has no row')
    call tap%ok(index(words, 'greatest -1.25 at STA -5|') > 0, &
        'the greatest curvature is told: TOP at its ends, a/b**2')
    call tap%ok(count_of('joint') == 7, 'joints are marked: one a view')
    call tap%ok(count_of('line') == 14, 'and each arc drawn')
    call tap%ok(count_of('ridge') == 14, 'with its ridge')
    drawing = combs_drawing(cylinder(1.0_dp, 4.0_dp), 'PIPE', 'mm')
    call tap%ok(count_of('tooth') == 0 .and. count_of('line') == 7, 'straight lines have no teeth')
    call tap%finish()

contains

    !> How many lines there are of a style.
    integer function count_of(style) result(number)
        character(*), intent(in) :: style
        integer :: k
        number = 0
        do k = 1, drawing%layers
            if (drawing%layer(k)%style == style) number = number + drawing%layer(k)%count
        end do
    end function count_of

end program test_body_combs
