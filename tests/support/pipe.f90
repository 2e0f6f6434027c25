!> The upper starboard quarter of a cylinder of radius 10 about the axis of STA, from station 0 to
!> 40, with a line SHO on it at BL 6, WL 8.
module support_pipe
    use base_fault, only: fault_list_type
    use body_body, only: body_type
    use body_build, only: build_body
    use body_ledger, only: joint_type
    use deck_job, only: job_type
    use support_job_deck, only: job_of
    implicit none (type, external)
    private

    public :: pipe_body

    !> Its cards.
    character(*), parameter, public :: pipe_cards = 'LINE,UCL,SIDE|STRAIGHT,0,10,40,10|'// &
        'LINE,MHB,SIDE,0.|LINE,MHB,PLAN|STRAIGHT,0,10,40,10|LINE,SHO,SIDE|STRAIGHT,0,8,40,8|'// &
        'LINE,SHO,PLAN|STRAIGHT,0,6,40,6|SECTION,TOP,UCL,SHO,MHB,0,999.999|'

contains

    !> The body, with cards behind its own.
    subroutine pipe_body(cards, job, body, faults)
        character(*), intent(in) :: cards               !! with | between them
        type(job_type), intent(out) :: job              !! what they ask for
        type(body_type), intent(out) :: body            !! its lines and section
        type(fault_list_type), intent(out) :: faults    !! what is wrong
        type(joint_type), allocatable :: joints(:)
        call job_of(pipe_cards//cards, job, faults)
        call build_body(job, 1, body, joints, faults)
    end subroutine pipe_body

end module support_pipe
