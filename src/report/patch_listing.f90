!> The patches of a body on pages: how near the edges are to the sides, and which way the middle
!> faces, so that sides named the wrong way round are seen.
!>
!>     PATCHES                OUTWARD NORMAL IN THE MIDDLE
!>     PATCH       EDGES OFF       STA        BL        WL
!>     CAP          3.51E-08 -0.517193  0.620121  0.589891
!>
!> Then how sides that are TANGENT meet what lies beside them: the largest angle between the normals
!> of both, and where it is.
!>
!>     TANGENT SIDES                  LARGEST ANGLE
!>     PATCH       SIDE  BESIDE       DEGREES       STA        BL        WL
!>     CAP            3  UPPER       2.41E-07    10.000     4.123     7.011
module report_patch_listing
    use base_digits, only: fixed, scientific
    use base_kinds, only: dp
    use base_output, only: output_type
    use base_text, only: compact, right, to_text
    use base_tolerances, only: tangency_tolerance
    use body_panel, only: joint_type, panel_type
    use cut_panel_point, only: panel_normal
    use geom_coons, only: patch_jet_type
    use geom_surface_jet, only: second_jet
    use report_ordinate, only: ordinate_form_type, ordinate_text
    use report_page, only: page_columns, page_type
    implicit none (type, external)
    private

    public :: print_patches

    !> Columns of the table, decimals of a direction.
    integer, parameter :: name_width = 11, error_width = 10, part_width = 10, part_decimals = 6
    !> Columns of the number of a side and of what lies beside it.
    integer, parameter :: side_width = 5, beside_width = 10
    !> Angles below it are rounding and print as zero, degrees.
    real(dp), parameter :: angle_noise = 1.0e-7_dp

contains

    !> Prints the patches of a body; nothing where it has none. Ducts have pages of their own.
    subroutine print_patches(page, panels, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(panel_type), intent(in) :: panels(:)       !! the patches, and ducts
        type(ordinate_form_type), intent(in) :: form    !! unit of the errors
        type(output_type), intent(inout) :: out         !! where they go
        character(page_columns) :: head(2)
        integer :: i

        if (all(panels%is_round)) return
        call page%keep(out, 6)
        head(1) = 'PATCHES'//right('OUTWARD NORMAL IN THE MIDDLE', &
            name_width + error_width + 3*part_width - 7)
        head(2) = 'PATCH      '//right('EDGES OFF', error_width)//right('STA', part_width)// &
            right('BL', part_width)//right('WL', part_width)
        call page%set_columns(out, head)
        do i = 1, size(panels)
            if (.not. panels(i)%is_round) call page%line(out, row(panels(i), form))
        end do
        call page%end_columns()
        call print_joints(page, panels, form, out)
        call page%blank(out)
        call page%blank(out)
    end subroutine print_patches

    !> Prints how the patches of a body meet what lies beside their sides that are TANGENT.
    subroutine print_joints(page, panels, form, out)
        type(page_type), intent(inout) :: page          !! the listing
        type(panel_type), intent(in) :: panels(:)       !! the patches
        type(ordinate_form_type), intent(in) :: form    !! unit of the ordinates
        type(output_type), intent(inout) :: out         !! where they go
        character(page_columns) :: head(2)
        integer :: i, k

        if (.not. any([(any(panels(i)%joint%name /= ''), i = 1, size(panels))])) return
        call page%blank(out)
        call page%keep(out, 5)
        head(1) = 'TANGENT SIDES'//right('LARGEST ANGLE', name_width + side_width + 2 + &
            beside_width + error_width - 13)
        head(2) = 'PATCH      '//right('SIDE', side_width)//'  BESIDE    '// &
            right('DEGREES', error_width)//right('STA', part_width)//right('BL', part_width)// &
            right('WL', part_width)
        call page%set_columns(out, head)
        do i = 1, size(panels)
            do k = 1, 4
                if (panels(i)%joint(k)%name == '') cycle
                call page%line(out, joint_row(panels(i)%name, k, panels(i)%joint(k), form))
            end do
        end do
        call page%end_columns()
        call page%line(out, 'ALLOWED: '//compact(tangency_tolerance)//' DEGREES')
    end subroutine print_joints

    !> The row of a joint.
    pure function joint_row(name, number, joint, form) result(text)
        character(*), intent(in) :: name                !! of the patch
        integer, intent(in) :: number                   !! of the side
        type(joint_type), intent(in) :: joint           !! of the side
        type(ordinate_form_type), intent(in) :: form    !! unit of the ordinates
        character(page_columns) :: text
        integer :: at, i

        text = name
        text(name_width + 1:) = right(to_text(number), side_width)//'  '//joint%name
        at = name_width + side_width + 2 + beside_width
        text(at + 1:) = scientific(merge(joint%angle, 0.0_dp, joint%angle > angle_noise), &
            error_width, 2)
        do i = 1, 3
            text(at + error_width + part_width*(i - 1) + 1:) = &
                ordinate_text(form, joint%worst(i), part_width)
        end do
    end function joint_row

    !> The row of a patch.
    pure function row(panel, form) result(text)
        type(panel_type), intent(in) :: panel           !! the patch
        type(ordinate_form_type), intent(in) :: form    !! unit of the error
        character(page_columns) :: text
        type(patch_jet_type) :: middle
        real(dp) :: normal(3)
        logical :: is_regular
        integer :: i

        middle = second_jet(panel%surface, 0.5_dp, 0.5_dp)
        call panel_normal(panel, middle, normal, is_regular)
        text = panel%name
        text(name_width + 1:) = scientific(form%factor*panel%error, error_width, 2)
        if (.not. is_regular) return
        do i = 1, 3
            text(name_width + error_width + part_width*(i - 1) + 1:) = &
                fixed(normal(i), part_width, part_decimals)
        end do
    end function row

end module report_patch_listing
