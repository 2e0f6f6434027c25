!> The figures of SAE 700202, Table 4, as points of the nose, and how far they are from the surface
!> that LOFT makes of the control lines of Table 1 alone.
module support_book_nose
    use base_fault, only: fault_list_type
    use base_kinds, only: dp
    use body_body, only: body_type
    use body_build, only: build_body
    use body_ledger, only: joint_type
    use body_section, only: section_arc
    use body_surface, only: form_along, patch_at, patch_type
    use body_taylor, only: taylor_type
    use base_error, only: error_type
    use deck_job, only: job_type
    use geom_arc, only: arc_type
    use support_book, only: figure_type, text_file
    use support_computed, only: job_of_text
    implicit none (type, external)
    private

    public :: nose_of_deck, is_of_nose, point_of, off_nose

    !> Steps to the surface; each halves the figures that are missing.
    integer, parameter :: steps = 4

contains

    !> The body of `cards/nose.crd`.
    subroutine nose_of_deck(nose)
        type(body_type), intent(out) :: nose !! the lower quarter
        type(joint_type), allocatable :: joints(:)
        type(fault_list_type) :: faults
        type(job_type) :: job

        call job_of_text(text_file('cards/nose.crd'), job, faults)
        call build_body(job, 1, nose, joints, faults)
        if (faults%count > 0) error stop 'cards/nose.crd is at fault'
    end subroutine nose_of_deck

    !> True for a figure of Table 4.
    elemental logical function is_of_nose(figure)
        type(figure_type), intent(in) :: figure !! an ordinate
        is_of_nose = figure%table == '4'
    end function is_of_nose

    !> The point of a figure: its section is called `STA 10` or `STA 0 floor`, X is BL and Y is WL.
    function point_of(figure) result(at)
        type(figure_type), intent(in) :: figure !! of table 4
        real(dp) :: at(3)
        character(4) :: word
        real(dp) :: found

        read (figure%line, *) word, at(1)
        read (figure%restored, *) found
        at(2:) = [figure%place(), found]
        if (figure%axis == 'Y') at(2:) = at([3, 2])
    end function point_of

    !> The distance of a point from the nose, normal to it, positive outside: by steps along the
    !> gradient of the surface as an implicit function. The point must be next to the surface.
    subroutine off_nose(nose, at, distance)
        type(body_type), intent(in) :: nose     !! of one section
        real(dp), intent(in) :: at(3)           !! STA, BL, WL, inches
        real(dp), intent(out) :: distance       !! inches
        real(dp) :: foot(3), gradient(3), way(3)
        type(patch_type) :: patch
        type(taylor_type) :: form
        type(arc_type) :: arc
        type(error_type), allocatable :: error
        integer :: i, axis

        foot = at
        do i = 1, steps
            call section_arc(nose%lines, nose%sections(1), foot(1), arc, error)
            if (allocated(error)) error stop 'the nose has no section at a figure of the book'
            patch = patch_at(nose%lines, nose%sections(1), foot(1), arc)
            do axis = 1, 3
                way = 0.0_dp
                way(axis) = 1.0_dp
                form = form_along(patch, foot(2:), way)
                gradient(axis) = form%first
            end do
            foot = foot - form%value/dot_product(gradient, gradient)*gradient
        end do
        distance = sign(norm2(at - foot), (at(2) - foot(2)) - (at(3) - foot(3)))
    end subroutine off_nose

end module support_book_nose
