!> The path of a tool along an outline: straight pieces and circular arcs end to end.
module export_nc_path
    use base_kinds, only: dp
    use base_output, only: output_type
    use export_nc_word, only: word
    implicit none (type, external)
    private

    public :: segment_type, path_type, run_type, straight_path, put_path

    !> Figures of a coordinate or radius that every control reads; the first coordinate beyond any
    !> machine.
    integer, parameter, public :: read_figures = 8
    real(dp), parameter, public :: farthest = 1.0e5_dp

    !> A piece of a path, from where the last one ended.
    type :: segment_type
        real(dp) :: to(2) = 0.0_dp          !! where it ends
        logical :: is_arc = .false.         !! circular, else straight
        logical :: is_clockwise = .false.   !! of an arc, seen from above
        real(dp) :: centre(2) = 0.0_dp      !! of an arc
    end type segment_type

    !> A path.
    type :: path_type
        real(dp) :: start(2) = 0.0_dp                   !! where it begins
        type(segment_type), allocatable :: segments(:)  !! one or more
    end type path_type

    !> How paths are run.
    type :: run_type
        real(dp) :: safe = 0.0_dp           !! Z above everything
        real(dp) :: depth = 0.0_dp          !! Z of the cut
        real(dp) :: feed = 0.0_dp           !! along the path, a minute
        real(dp) :: plunge = 0.0_dp         !! down to the depth, a minute
        real(dp) :: tolerance = 0.0_dp      !! how far a path may be from the exact shape
        integer :: decimals = 0             !! of coordinates
        logical :: has_arcs = .false.       !! paths are of circular arcs
    end type run_type

    !> Decimals of feeds.
    integer, parameter :: feed_decimals = 1

contains

    !> The path along a polygon.
    pure type(path_type) function straight_path(at, is_closed) result(path)
        real(dp), intent(in) :: at(:, :)    !! corners by columns, two or more
        logical, intent(in) :: is_closed    !! the last is joined to the first
        integer :: i, count

        count = size(at, 2)
        path%start = at(:, 1)
        allocate (path%segments(merge(count, count - 1, is_closed)))
        do i = 1, size(path%segments)
            path%segments(i)%to = at(:, 1 + mod(i, count))
        end do
    end function straight_path

    !> Puts a path: rapidly above its start, down, along it, and up.
    subroutine put_path(out, path, run)
        type(output_type), intent(inout) :: out     !! gets the blocks
        type(path_type), intent(in) :: path         !! the path
        type(run_type), intent(in) :: run           !! how
        real(dp) :: from(2)
        integer :: i

        call out%line('G0 '//place(path%start, run%decimals))
        call out%line('G1 '//word('Z', run%depth, run%decimals)//' '// &
            word('F', run%plunge, feed_decimals))
        from = path%start
        do i = 1, size(path%segments)
            associate (segment => path%segments(i))
                if (i == 1) then
                    call out%line(block_of(from, segment, run%decimals)//' '// &
                        word('F', run%feed, feed_decimals))
                else
                    call out%line(block_of(from, segment, run%decimals))
                end if
                from = segment%to
            end associate
        end do
        call out%line('G0 '//word('Z', run%safe, run%decimals))
    end subroutine put_path

    !> The block of a piece; I and J lead from its start to the centre.
    pure function block_of(from, segment, decimals) result(text)
        real(dp), intent(in) :: from(2)             !! where it begins
        type(segment_type), intent(in) :: segment   !! the piece
        integer, intent(in) :: decimals             !! of coordinates
        character(:), allocatable :: text

        if (segment%is_arc) then
            text = merge('G2 ', 'G3 ', segment%is_clockwise)//place(segment%to, decimals)//' '// &
                word('I', segment%centre(1) - from(1), decimals)//' '// &
                word('J', segment%centre(2) - from(2), decimals)
        else
            text = 'G1 '//place(segment%to, decimals)
        end if
    end function block_of

    !> The words of a place.
    pure function place(at, decimals) result(text)
        real(dp), intent(in) :: at(2)       !! X and Y
        integer, intent(in) :: decimals     !! behind the point
        character(:), allocatable :: text
        text = word('X', at(1), decimals)//' '//word('Y', at(2), decimals)
    end function place

end module export_nc_path
