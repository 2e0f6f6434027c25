!> Ways along a track of a panel. A place on a track is a number s from 0 to its pieces: the whole
!> part says which piece, the rest how far along its chord.
module cut_panel_walk
    use base_exact, only: is_zero
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    use body_panel, only: panel_type
    use cut_panel_track, only: panel_track_type
    use cut_plane, only: height_over, plane_type
    use geom_coons, only: patch_jet_type
    use geom_surface_jet, only: second_jet
    use geom_bspline_surface, only: surface_jet
    implicit none (type, external)
    private

    public :: walk_type, uv_at, point_at, jet_at, last_place, part_between, turned_track

    !> A track with what it lies on.
    type :: walk_type
        type(panel_type) :: panel           !! the panel
        type(plane_type) :: plane           !! the plane
        type(panel_track_type) :: track     !! of both
    end type walk_type

    !> Newton steps that put a point on panel and plane.
    integer, parameter :: most_steps = 30
    !> Below this sine of the angle between panel and plane, or between chord and track, no step is
    !> made: the point between the neighbours stands.
    real(dp), parameter :: least_sine = 1.0e-9_dp

contains

    !> The last place of a track.
    pure real(dp) function last_place(walk)
        type(walk_type), intent(in) :: walk !! any
        last_place = real(size(walk%track%uv, 2) - 1, dp)
    end function last_place

    !> The parameters of a place: on the panel, in the plane, and as far along the chord of the
    !> piece as the place says, by Newton's method.
    pure function uv_at(walk, s) result(uv)
        type(walk_type), intent(in) :: walk !! the track
        real(dp), intent(in) :: s           !! 0 to `last_place`
        real(dp) :: uv(2)
        real(dp) :: share, chord(3), target(3), at(3), du(3), dv(3), n(3), m(2, 2), off(2), step(2)
        real(dp) :: det
        integer :: piece, i

        piece = min(1 + int(s), size(walk%track%uv, 2) - 1)
        share = s - real(piece - 1, dp)
        associate (uvs => walk%track%uv(:, piece:piece + 1), &
            ends => walk%track%at(:, piece:piece + 1))
            uv = uvs(:, merge(1, 2, share < 0.5_dp))
            if (is_zero(share) .or. is_zero(1.0_dp - share)) return
            uv = on_panel(walk%panel, (1.0_dp - share)*uvs(:, 1) + &
                share*next_to(walk%panel, uvs(:, 1), uvs(:, 2)))
            chord = ends(:, 2) - ends(:, 1)
            target = (1.0_dp - share)*ends(:, 1) + share*ends(:, 2)
        end associate
        chord = chord/max(norm2(chord), tiny(1.0_dp))
        n = walk%plane%normal/norm2(walk%plane%normal)
        do i = 1, most_steps
            call surface_jet(walk%panel%surface, uv(1), uv(2), at, du, dv)
            off = [height_over(walk%plane, at), dot_product(chord, at - target)]
            m = reshape([dot_product(n, du), dot_product(chord, du), dot_product(n, dv), &
                dot_product(chord, dv)], [2, 2])
            det = m(1, 1)*m(2, 2) - m(1, 2)*m(2, 1)
            if (abs(det) <= least_sine*norm2(du)*norm2(dv)) return
            step = [off(1)*m(2, 2) - off(2)*m(1, 2), off(2)*m(1, 1) - off(1)*m(2, 1)]/det
            uv = on_panel(walk%panel, uv - step)
            if (all(abs(step) <= 2.0_dp*ulp)) return
        end do
    end function uv_at

    !> A place near another; around a duct on the short way from it, maybe beyond 0 or 1.
    pure function next_to(panel, one, other) result(place)
        type(panel_type), intent(in) :: panel   !! any
        real(dp), intent(in) :: one(2)          !! u and v
        real(dp), intent(in) :: other(2)        !! u and v
        real(dp) :: place(2)
        place = other
        if (panel%is_round) place(1) = other(1) - anint(other(1) - one(1))
    end function next_to

    !> A place brought back onto a panel; around a duct it goes on.
    pure function on_panel(panel, uv) result(place)
        type(panel_type), intent(in) :: panel   !! any
        real(dp), intent(in) :: uv(2)           !! a place, maybe beyond
        real(dp) :: place(2)
        place = min(max(uv, 0.0_dp), 1.0_dp)
        if (panel%is_round) place(1) = modulo(uv(1), 1.0_dp)
    end function on_panel

    !> The point of a place, deck units.
    pure function point_at(walk, s) result(at)
        type(walk_type), intent(in) :: walk !! the track
        real(dp), intent(in) :: s           !! 0 to `last_place`
        real(dp) :: at(3)
        type(patch_jet_type) :: jet
        jet = jet_at(walk, s)
        at = jet%at
    end function point_at

    !> The panel at a place.
    pure type(patch_jet_type) function jet_at(walk, s) result(jet)
        type(walk_type), intent(in) :: walk !! the track
        real(dp), intent(in) :: s           !! 0 to `last_place`
        real(dp) :: uv(2)
        uv = uv_at(walk, s)
        jet = second_jet(walk%panel%surface, uv(1), uv(2))
    end function jet_at

    !> The part of a track between two places, run through from the first to the second; of a closed
    !> track the second may be beyond the last place, once round.
    pure type(panel_track_type) function part_between(walk, from, to) result(part)
        type(walk_type), intent(in) :: walk !! the track
        real(dp), intent(in) :: from        !! 0 to `last_place`
        real(dp), intent(in) :: to          !! above `from`
        real(dp), allocatable :: place(:)
        real(dp) :: s, last
        integer :: i, k

        last = last_place(walk)
        allocate (place(0))
        place = [from, (real(k, dp), k = int(from) + 1, ceiling(to) - 1), to]
        allocate (part%uv(2, size(place)), part%at(3, size(place)))
        do i = 1, size(place)
            s = place(i)
            if (s > last) s = s - last
            part%uv(:, i) = uv_at(walk, s)
            part%at(:, i) = point_at(walk, s)
        end do
    end function part_between

    !> A track run through backwards.
    pure type(panel_track_type) function turned_track(track) result(back)
        type(panel_track_type), intent(in) :: track !! any
        back = track
        back%uv = track%uv(:, size(track%uv, 2):1:-1)
        back%at = track%at(:, size(track%at, 2):1:-1)
    end function turned_track

end module cut_panel_walk
