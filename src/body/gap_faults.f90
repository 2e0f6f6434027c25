!> Stations where the lines of a section are there and its conic is not, or goes the long way round,
!> said of its card.
module body_gap_faults
    use base_fault, only: fault_list_type
    use base_text, only: compact
    use body_body, only: body_type, is_image
    use body_gap, only: gap_type, section_gaps, section_turns
    use deck_body_card, only: blame, warn
    use deck_job, only: asked_body_type => body_type
    implicit none (type, external)
    private

    public :: report_gaps, warn_of_turns

contains

    !> Reports where a section has no conic though its lines are there; of one of BOTH sides once.
    pure subroutine report_gaps(asked, body, faults)
        type(asked_body_type), intent(in) :: asked              !! as the deck has it
        type(body_type), intent(in) :: body                     !! as built
        type(fault_list_type), intent(inout) :: faults          !! gets a fault for each gap
        type(gap_type), allocatable :: gaps(:)
        integer :: i, j, k

        do i = 1, size(body%sections)
            if (is_image(body, i)) cycle
            gaps = section_gaps(body, body%sections(i))
            j = findloc(asked%section%name, body%sections(i)%name, dim=1)
            do k = 1, size(gaps)
                call blame(asked%section(j)%card, 2, 'no conic from STA '// &
                    compact(gaps(k)%from)//' to '//compact(gaps(k)%to)//': '//gaps(k)%reason, &
                    faults)
            end do
        end do
    end subroutine report_gaps

    !> Warns of a section whose conic turns by more than 180 degrees; of one of BOTH sides once.
    pure subroutine warn_of_turns(asked, body, faults)
        type(asked_body_type), intent(in) :: asked              !! as the deck has it
        type(body_type), intent(in) :: body                     !! as built
        type(fault_list_type), intent(inout) :: faults          !! gets a warning for each stretch
        type(gap_type), allocatable :: turns(:)
        integer :: i, j, k

        do i = 1, size(body%sections)
            if (is_image(body, i)) cycle
            turns = section_turns(body, body%sections(i))
            j = findloc(asked%section%name, body%sections(i)%name, dim=1)
            do k = 1, size(turns)
                call warn(asked%section(j)%card, 4, 'the section turns by more than 180 '// &
                    'degrees from STA '//compact(turns(k)%from)//' to '//compact(turns(k)%to)// &
                    ': its shoulder point and the intersection of its end tangents are on '// &
                    'different sides of the chord', faults)
            end do
        end do
    end subroutine warn_of_turns

end module body_gap_faults
