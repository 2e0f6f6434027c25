!> From a CHECK card to the component whose clearance is measured: where deck and cut layers meet.
module sweep_component
    use base_decimal, only: to_real
    use cut_clearance, only: component_kind, component_type
    use deck_job, only: check, check_real, check_type
    implicit none (type, external)
    private

    public :: component_of

contains

    !> A component of a CHECK card.
    pure type(component_type) function component_of(card) result(component)
        type(check_type), intent(in) :: card !! the card

        component%name = card%name
        component%clearance = to_real(card%clearance)
        component%skin = to_real(card%skin)
        component%at = check_real(card, [1, 2, 3])
        select case (card%kind)
        case (check%sphere)
            component%kind = component_kind%sphere
            component%radius = check_real(card, 4)
        case (check%box)
            component%kind = component_kind%box
            component%other = check_real(card, [4, 5, 6])
        case default
            component%kind = component_kind%point
        end select
    end function component_of

end module sweep_component
