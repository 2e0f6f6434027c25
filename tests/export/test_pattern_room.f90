!> Tests of taken room.
program test_pattern_room
    use base_kinds, only: dp
    use export_pattern_page, only: label_type
    use export_pattern_room, only: meets_box, meets_corners, room_type
    use support_random, only: random_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(room_type) :: room
    type(label_type) :: label
    real(dp), parameter :: box(4) = [0.0_dp, 0.0_dp, 2.0_dp, 1.0_dp], &
        diamond(2, 4) = reshape([1.0_dp, 0.0_dp, 2.0_dp, 1.0_dp, 1.0_dp, 2.0_dp, 0.0_dp, &
        1.0_dp], [2, 4])
    integer :: i

    call tap%ok(meets_box([-1.0_dp, 0.5_dp, 3.0_dp, 0.5_dp], box), 'a line across a box meets it')
    call tap%ok(meets_box([0.5_dp, 0.5_dp, 0.6_dp, 0.5_dp], box), 'one inside does')
    call tap%ok(meets_box([-1.0_dp, 0.5_dp, 1.0_dp, -0.5_dp], box), 'one through the corner does')
    call tap%ok(.not. meets_box([-1.0_dp, 0.4_dp, 1.0_dp, -0.6_dp], box), 'one past it does not')
    call tap%ok(.not. meets_box([3.0_dp, -1.0_dp, 3.0_dp, 2.0_dp], box), 'an upright one beside it')
    call tap%ok(meets_box([2.0_dp, -1.0_dp, 2.0_dp, 2.0_dp], box), 'touching counts')
    call tap%ok(meets_box([1.0_dp, 0.5_dp, 1.0_dp, 0.5_dp], box), 'a point inside meets it')
    call tap%ok(meets_corners([0.0_dp, 0.0_dp, 0.6_dp, 0.6_dp], diamond), 'a diamond is met')
    call tap%ok(.not. meets_corners([0.0_dp, 0.0_dp, 0.4_dp, 0.4_dp], diamond), &
        'before it is empty')

    label%text = 'WL 5'
    label%height = 0.1_dp
    call tap%ok(room%is_free([0.0_dp, 0.0_dp], label), 'where nothing is all is free')
    call room%take_line(reshape([0.1_dp, -1.0_dp, 0.1_dp, 1.0_dp], [2, 2]))
    call tap%ok(.not. room%is_free([0.0_dp, 0.0_dp], label), 'a line is not hidden')
    call tap%ok(room%is_free([0.12_dp, 0.0_dp], label), 'beside it there is room')
    call room%take_label([0.12_dp, 0.0_dp], label)
    call tap%ok(.not. room%is_free([0.3_dp, 0.05_dp], label), 'nor are words')
    call tap%ok(room%is_free([0.12_dp, 0.1_dp], label), 'above them there is room')
    label%along = [0.0_dp, 1.0_dp]
    call tap%ok(.not. room%is_free([0.2_dp, -0.1_dp], label), 'upright words do not cross others')
    call try_many()
    do i = 1, 100
        call room%take_line(reshape([0.0_dp, real(i, dp), 1.0_dp, real(i, dp)], [2, 2]))
        call room%take_label([5.0_dp, real(i, dp)], label)
    end do
    call tap%ok(room%lines == 101 .and. room%words == 101, 'lists grow')
    call tap%finish()

contains

    !> Compares with points along many lines: those inside of the box are met.
    subroutine try_many()
        type(random_type) :: random
        real(dp) :: line(4), at(2)
        integer :: i, k, wrong

        wrong = 0
        do i = 1, 2000
            do k = 1, 4
                line(k) = random%between(-2.0_dp, 4.0_dp)
            end do
            do k = 0, 50
                at = line(:2) + real(k, dp)/50.0_dp*(line(3:) - line(:2))
                if (all(at > box(:2)) .and. all(at < box(3:)) .and. .not. meets_box(line, box)) &
                    wrong = wrong + 1
            end do
        end do
        call tap%ok(wrong == 0, 'no line with a point in a box is missed')
    end subroutine try_many

end program test_pattern_room
