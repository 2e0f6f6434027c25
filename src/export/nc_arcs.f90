!> A contour of circular arcs as the path of a tool, in rounded numbers that controls take: each arc
!> has its centre where both its rounded ends are on its circle, but for the rounding of I and J.
!>
!> With I and J rounded by e the distances of both ends from the centre differ by less than 2 e:
!> .00014 inch or .0014 mm with the usual decimals. NIST's interpreter takes .0002 inch and
!> .002 mm, LinuxCNC .0005 inch and .005 mm, Grbl .005 mm.
!>
!> Source: NISTIR 6556 (2000), section 3.5.3; LinuxCNC, "G-Codes", G2, G3; Grbl v1.1, error 33.
module export_nc_arcs
    use base_kinds, only: dp
    use export_chords, only: rounded
    use export_nc_path, only: farthest, path_type, read_figures, segment_type
    use geom_circular, only: circular_type, parted_circular
    implicit none (type, external)
    private

    public :: arc_path

    !> The rise of an arc, units of the last decimal, that is lost in rounding.
    real(dp), parameter :: lost_rise = 0.5_dp

contains

    !> The path along arcs. An arc whose rise is lost in rounding is straight; one whose radius has
    !> more figures than controls read is straight pieces that differ from it no more than that;
    !> one whose ends fall together is left out. Without arcs that stay the path has no segments.
    pure type(path_type) function arc_path(arcs, decimals) result(path)
        type(circular_type), intent(in) :: arcs(:)  !! end to end, none of more than 180 degrees
        integer, intent(in) :: decimals             !! of coordinates
        real(dp) :: at(2)
        integer :: i

        allocate (path%segments(0))
        if (size(arcs) == 0) return
        path%start = rounded(arcs(1)%start, decimals)
        at = path%start
        do i = 1, size(arcs)
            if (is_wide(arcs(i), decimals)) then
                call add_chords(arcs(i), decimals, at, path)
            else
                call add_arc(arcs(i), decimals, at, path)
            end if
        end do
    end function arc_path

    !> True where the radius has more figures than controls read. Where the ends are beyond any
    !> machine, which the caller refuses, it does not matter.
    pure logical function is_wide(arc, decimals)
        type(circular_type), intent(in) :: arc      !! any
        integer, intent(in) :: decimals             !! of coordinates
        is_wide = abs(arc%radius) >= 10.0_dp**(read_figures - decimals) .and. &
            max(maxval(abs(arc%start)), maxval(abs(arc%finish))) < farthest
    end function is_wide

    !> Adds an arc, or the straight piece that it is.
    pure subroutine add_arc(arc, decimals, at, path)
        type(circular_type), intent(in) :: arc      !! of a radius that controls read
        integer, intent(in) :: decimals             !! of coordinates
        real(dp), intent(inout) :: at(2)            !! where the path is; then the arc's end
        type(path_type), intent(inout) :: path      !! gets the piece
        type(segment_type) :: segment
        real(dp) :: way(2), half

        segment%to = rounded(arc%finish, decimals)
        way = segment%to - at
        if (all(abs(way) <= 0.0_dp)) return
        segment%is_arc = rise_of(arc)*10.0_dp**decimals > lost_rise
        if (segment%is_arc) then
            half = 0.5_dp*arc%turn
            segment%is_clockwise = arc%turn < 0.0_dp
            segment%centre = at + rounded(0.5_dp*(way + [-way(2), way(1)]*cos(half)/sin(half)), &
                decimals)
        end if
        path%segments = [path%segments, segment]
        at = segment%to
    end subroutine add_arc

    !> Adds an arc of very large radius as straight pieces: the rise of a part goes with the square
    !> of its turn.
    pure subroutine add_chords(arc, decimals, at, path)
        type(circular_type), intent(in) :: arc      !! with a centre
        integer, intent(in) :: decimals             !! of coordinates
        real(dp), intent(inout) :: at(2)            !! where the path is; then the arc's end
        type(path_type), intent(inout) :: path      !! gets the pieces
        type(circular_type), allocatable :: parts(:)
        integer :: i

        allocate (parts(1 + int(sqrt(rise_of(arc)*10.0_dp**decimals/lost_rise))))
        parts = parted_circular(arc, size(parts))
        do i = 1, size(parts)
            parts(i)%is_line = .true.
            call add_arc(parts(i), decimals, at, path)
        end do
    end subroutine add_chords

    !> How far the middle of an arc is from its chord, deck units.
    pure real(dp) function rise_of(arc) result(rise)
        type(circular_type), intent(in) :: arc !! any
        rise = 0.0_dp
        if (arc%is_line) return
        rise = abs(arc%radius)*2.0_dp*sin(0.25_dp*arc%turn)**2
    end function rise_of

end module export_nc_arcs
