!> Faired outlines: closed curves at a station near measured points, with a prescribed area where
!> one is asked for. No section of the body knows them; a duct may go through them.
module body_outline
    use base_decimal, only: to_real
    use base_error, only: cause, error_type
    use base_exact, only: is_equal
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_points, only: points_of, weights_of
    use deck_body_card, only: blame
    use deck_job, only: asked_outline_type => outline_type, body_type, name_length, piece_real
    use geom_fairing, only: fair, fair_to_area, fairing_type
    use geom_fairing_system, only: fairing_data_type, fairing_end, spline_area
    implicit none (type, external)
    private

    public :: outline_type, build_outlines, find_outline

    !> An outline.
    type :: outline_type
        character(name_length) :: name = ''     !! its name
        real(dp) :: sta = 0.0_dp                !! its station, deck units
        type(fairing_data_type) :: measured     !! its points (BL, WL) and their weights
        logical :: has_area = .false.           !! its area was asked for
        real(dp) :: area = 0.0_dp               !! that area, deck units squared
        real(dp) :: arcs = 0.0_dp               !! tolerance of circular arcs in its place, deck
                                                !! units; 0: not asked
        type(fairing_type) :: fairing           !! the outline; its area is below zero where it runs
                                                !! clockwise with BL to the right, WL upwards
    end type outline_type

contains

    !> Fairs the outlines of a body. What can't be faired is said of its card and left out.
    pure subroutine build_outlines(asked, list, faults)
        type(body_type), intent(in) :: asked                        !! as the deck has it
        type(outline_type), allocatable, intent(out) :: list(:)     !! those that could be faired
        type(fault_list_type), intent(inout) :: faults              !! what is wrong is added
        type(outline_type) :: item
        type(error_type), allocatable :: error
        integer :: i

        allocate (list(0))
        do i = 1, size(asked%outline)
            if (.not. asked%outline(i)%is_sound) cycle
            if (comes_back(asked%outline(i))) then
                call blame(asked%outline(i)%piece(size(asked%outline(i)%piece))%card, 1, &
                    'the last point is the first again; the outline closes by itself: leave it '// &
                    'out', faults)
                cycle
            end if
            call build_outline(asked%outline(i), item, error)
            if (allocated(error)) then
                call blame(asked%outline(i)%card, merge(6, 2, error%cause == cause%no_area), &
                    error%message, faults)
            else
                list = [list, item]
            end if
        end do
    end subroutine build_outlines

    !> Which outline has a name; 0 where none has: it could not be faired.
    pure integer function find_outline(list, name) result(number)
        type(outline_type), intent(in) :: list(:)   !! of a body
        character(*), intent(in) :: name            !! in capitals
        do number = size(list), 1, -1
            if (list(number)%name == name) return
        end do
    end function find_outline

    !> True where the last point is the first one.
    pure logical function comes_back(asked)
        type(asked_outline_type), intent(in) :: asked !! as the deck has it
        associate (last => size(asked%piece))
            comes_back = last > 1 .and. all(is_equal(piece_real(asked%piece(1), [1, 2]), &
                piece_real(asked%piece(last), [1, 2])))
        end associate
    end function comes_back

    !> Fairs an outline.
    !>
    !> Fails as `fair` and `fair_to_area`.
    pure subroutine build_outline(asked, item, error)
        type(asked_outline_type), intent(in) :: asked       !! as the deck has it
        type(outline_type), intent(out) :: item             !! the outline
        type(error_type), allocatable, intent(out) :: error !! see above

        item%name = asked%name
        item%sta = to_real(asked%sta)
        item%has_area = asked%has_area
        item%area = to_real(asked%area)
        item%arcs = to_real(asked%arcs)
        item%measured%ends = fairing_end%closed
        item%measured%beta = to_real(asked%beta)
        item%measured%point = points_of(asked%piece)
        item%measured%weight = weights_of(asked%piece, asked%weight)
        if (item%has_area) then
            call fair_to_area(item%measured, sign(item%area, spline_area(item%measured%point, &
                .true.)), item%fairing, error)
        else
            call fair(item%measured, 0.0_dp, item%fairing, error)
        end if
    end subroutine build_outline

end module body_outline
