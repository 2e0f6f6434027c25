!> The ring folded flat: what makes its matrix a band.
program test_ring_band
    use base_text, only: to_text
    use geom_ring_band, only: folded
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    integer :: n

    call tap%ok(all(folded(6) == [1, 3, 5, 6, 4, 2]), 'six points, there and back')
    call tap%ok(all(folded(5) == [1, 3, 5, 4, 2]), 'five points')
    do n = 1, 8
        call check_ring(n)
    end do
    call tap%finish()

contains

    !> Every place is taken once, and neighbours are near, the last and the first too.
    subroutine check_ring(n)
        integer, intent(in) :: n !! points
        integer :: place(n), i

        place = folded(n)
        call tap%ok(all([(count(place == i), i = 1, n)] == 1), to_text(n)//' points: a place each')
        call tap%ok(all(abs(place - cshift(place, 1)) <= 2), &
            to_text(n)//' points: neighbours are at most two places apart')
    end subroutine check_ring

end program test_ring_band
