!> Faults as short texts, for tests to compare: `error 7:25-40 points 1 and 2 coincide; ...`, one a
!> line.
module support_faults
    use base_fault, only: fault_list_type, fault_type, severity
    use base_text, only: to_text
    implicit none (type, external)
    private

    public :: said, places

contains

    !> Every fault of a list with its words, a line feed between two.
    pure function said(list) result(text)
        type(fault_list_type), intent(in) :: list !! the faults
        character(:), allocatable :: text
        integer :: i
        text = ''
        do i = 1, list%count
            if (i > 1) text = text//new_line('a')
            text = text//place(list%item(i))//' '//list%item(i)%message
        end do
    end function said

    !> Severity and place of every fault, a comma between two.
    pure function places(list) result(text)
        type(fault_list_type), intent(in) :: list !! the faults
        character(:), allocatable :: text
        integer :: i
        text = ''
        do i = 1, list%count
            if (i > 1) text = text//', '
            text = text//place(list%item(i))
        end do
    end function places

    !> Severity and place of a fault.
    pure function place(fault) result(text)
        type(fault_type), intent(in) :: fault !! the fault
        character(:), allocatable :: text
        select case (fault%severity)
        case (severity%error)
            text = 'error '
        case (severity%warning)
            text = 'warning '
        case default
            text = 'remark '
        end select
        text = text//to_text(fault%line)//':'//to_text(fault%first)//'-'//to_text(fault%last)
    end function place

end module support_faults
