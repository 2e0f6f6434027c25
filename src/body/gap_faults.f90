!> Stations where the lines of a section are there and its conic is not, said of its card.
module body_gap_faults
    use base_fault, only: fault_list_type
    use base_text, only: compact
    use body_body, only: body_type
    use body_gap, only: gap_type, section_gaps
    use deck_body_card, only: blame
    use deck_job, only: asked_body_type => body_type
    implicit none (type, external)
    private

    public :: report_gaps

contains

    !> Reports where a section has no conic though its lines are there.
    pure subroutine report_gaps(asked, body, faults)
        type(asked_body_type), intent(in) :: asked              !! as the deck has it
        type(body_type), intent(in) :: body                     !! as built
        type(fault_list_type), intent(inout) :: faults          !! gets a fault for each gap
        type(gap_type), allocatable :: gaps(:)
        integer :: i, j, k

        do i = 1, size(body%sections)
            gaps = section_gaps(body, body%sections(i))
            do j = 1, size(asked%section)
                if (asked%section(j)%name /= body%sections(i)%name) cycle
                do k = 1, size(gaps)
                    call blame(asked%section(j)%card, 2, 'no conic from STA '// &
                        compact(gaps(k)%from)//' to '//compact(gaps(k)%to)//': '// &
                        gaps(k)%reason, faults)
                end do
                exit
            end do
        end do
    end subroutine report_gaps

end module body_gap_faults
