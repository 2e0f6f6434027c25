!> The continuity ledger on pages: each joint of each control line, as numbers and in words.
!>
!>     LINE      VIEW         STA        GAP     BREAK  CURVATURE BEFORE     AFTER
!>     UCL       SIDE      60.000   0.00E+00     0.000          1.25E-03  1.25E-03
!>       slope and curvature go on
module report_ledger_listing
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: right, upper
    use body_ledger, only: joint_type, joint_words
    use base_digits, only: fixed, scientific
    use report_ordinate, only: ordinate_form_type, ordinate_text
    use report_page, only: page_columns, page_type, widest_page
    implicit none (type, external)
    private

    public :: print_ledger

    !> The views by `view%...` of `deck_job`.
    character(5), parameter :: view_names(3) = ['SIDE ', 'PLAN ', 'ANGLE']
    !> Columns of the table, and decimals of a break in degrees.
    integer, parameter :: figure_width = 11, break_width = 10, break_decimals = 5

contains

    !> Prints the joints of a body's lines.
    subroutine print_ledger(page, joints, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(joint_type), intent(in) :: joints(:)       !! in the order of the lines
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        type(output_type), intent(inout) :: out         !! where it goes
        character(page_columns) :: head(2)
        character(:), allocatable :: words
        integer :: i

        if (size(joints) == 0) return
        call page%keep(out, 8)
        call page%line(out, 'CONTINUITY LEDGER')
        head(1) = '                            '//right('GAP', figure_width)// &
            right('BREAK', break_width)//right('CURVATURE', 2*figure_width)
        head(2) = 'LINE      VIEW  '//right('STA', figure_width + 1)// &
            right(form%unit, figure_width)//right('DEGREES', break_width)// &
            right('BEFORE', figure_width)//right('AFTER', figure_width)
        call page%set_columns(out, head)
        do i = 1, size(joints)
            words = '  '//upper(trim(joint_words(joints(i))))
            call page%keep(out, 2 + len(words)/page%width())
            call page%line(out, row(joints(i), form))
            call page%paragraph(out, words)
        end do
        call page%end_columns()
        call page%blank(out)
        call page%blank(out)
    end subroutine print_ledger

    !> The row of a joint.
    pure function row(joint, form) result(text)
        type(joint_type), intent(in) :: joint           !! the joint
        type(ordinate_form_type), intent(in) :: form    !! unit and decimals
        character(widest_page) :: text
        real(dp) :: curvature(2)

        curvature = joint%curvature/form%factor
        text = joint%line//'  '//view_names(joint%view)//' '// &
            ordinate_text(form, joint%sta, figure_width + 1)// &
            scientific(form%factor*joint%jump%gap, figure_width, 3)// &
            fixed(joint%jump%direction, break_width, break_decimals)// &
            scientific(curvature(1), figure_width, 4)//scientific(curvature(2), figure_width, 4)
    end function row

end module report_ledger_listing
