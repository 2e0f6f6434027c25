!> A chain at abscissas in a row: what `chain_value` and `chain_jet` say of one. The figures are the
!> same.
module geom_chain_row
    use base_kinds, only: dp
    use base_tolerances, only: ulp
    use geom_arc_row, only: arc_row_type, place_row_type, repeated_arc, row_curvatures
    use geom_chain, only: chain_jet, chain_piece, chain_type
    use geom_jet, only: jet_type
    use geom_ordinate_row, only: row_ordinates
    use geom_stroke, only: stroke_kind, stroke_type
    use geom_twofold_short, only: width
    implicit none (type, external)
    private

    public :: jet_row_type, row_jets

    !> Ordinates at a row of abscissas, and how they change.
    type :: jet_row_type
        real(dp) :: value(width)    !! deck units
        real(dp) :: first(width)    !! first derivatives
        real(dp) :: second(width)   !! second derivatives, 1/deck unit; where they are asked for
    end type jet_row_type

contains

    !> The ordinates at abscissas of the range with their derivatives; at a joint those after it.
    pure subroutine row_jets(chain, x, has_second, jets, is_vertical)
        type(chain_type), intent(in) :: chain           !! any chain
        real(dp), intent(in) :: x(width)                !! deck units
        logical, intent(in) :: has_second               !! second derivatives are asked for
        type(jet_row_type), intent(out) :: jets         !! see above
        logical, intent(out) :: is_vertical(width)      !! dy/dx is infinite; derivatives are zero
        logical :: is_left(width), is_inside(width)
        integer :: first

        is_vertical = .false.
        jets%value = chain%constant
        jets%first = 0.0_dp
        jets%second = 0.0_dp
        if (chain%is_constant) return
        is_left = .true.
        do while (any(is_left))
            first = findloc(is_left, .true., dim=1)
            associate (stroke => chain%stroke(chain_piece(chain, x(first))))
                is_inside = is_left .and. x > stroke%start(1) .and. x < stroke%finish(1)
                if (stroke%kind == stroke_kind%conic .and. is_inside(first)) then
                    call conic_jets(stroke, x, has_second, is_inside, jets, is_vertical)
                else
                    call jet_at(chain, x(first), first, jets, is_vertical)
                    is_inside = .false.
                    is_inside(first) = .true.
                end if
            end associate
            is_left = is_left .and. .not. is_inside
        end do
    end subroutine row_jets

    !> The ordinate at one abscissa of a row.
    pure subroutine jet_at(chain, x, i, jets, is_vertical)
        type(chain_type), intent(in) :: chain               !! no constant
        real(dp), intent(in) :: x                           !! deck units
        integer, intent(in) :: i                            !! which of the row
        type(jet_row_type), intent(inout) :: jets           !! gets it
        logical, intent(inout) :: is_vertical(width)        !! gets it, too
        type(jet_type) :: jet

        call chain_jet(chain, x, jet, is_vertical(i))
        jets%value(i) = jet%value
        jets%first(i) = jet%first
        jets%second(i) = jet%second
    end subroutine jet_at

    !> The ordinates at those abscissas of a row that are inside of a conic.
    pure subroutine conic_jets(stroke, x, has_second, is_inside, jets, is_vertical)
        type(stroke_type), intent(in) :: stroke             !! a conic towards greater x
        real(dp), intent(in) :: x(width)                    !! deck units
        logical, intent(in) :: has_second                   !! second derivatives are asked for
        logical, intent(in) :: is_inside(width)             !! which
        type(jet_row_type), intent(inout) :: jets           !! gets them
        logical, intent(inout) :: is_vertical(width)        !! gets them, too
        type(arc_row_type) :: arc
        type(place_row_type) :: place
        real(dp) :: inside(width), y(width), along(width, 2), bend(width)
        integer :: i

        inside = x
        if (.not. all(is_inside)) &
            inside = merge(x, 0.5_dp*(stroke%start(1) + stroke%finish(1)), is_inside)
        if (has_second) then
            call row_ordinates(stroke%arc, inside, y, along, place)
        else
            call row_ordinates(stroke%arc, inside, y, along)
        end if
        do i = 1, width
            if (.not. is_inside(i)) cycle
            jets%value(i) = y(i)
            is_vertical(i) = abs(along(i, 1)) <= ulp*abs(along(i, 2))
            if (.not. is_vertical(i) .and. abs(along(i, 2)) > 0.0_dp) &
                jets%first(i) = along(i, 2)/along(i, 1)
        end do
        if (.not. has_second) return
        call repeated_arc(stroke%arc, arc)
        call row_curvatures(arc, place, bend)
        do i = 1, width
            if (.not. is_inside(i) .or. is_vertical(i)) cycle
            jets%second(i) = bend(i)*(sqrt(along(i, 1)**2 + along(i, 2)**2)/along(i, 1))**3
        end do
    end subroutine conic_jets

end module geom_chain_row
