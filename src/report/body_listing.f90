!> The listing of a body deck, part by part in the order lofts print it: title page, then for each
!> body its ledger, faired lines, how its sections meet, offset tables, measures, clearances and
!> cuts.
module report_body_listing
    use base_output, only: output_type
    use body_body, only: body_type
    use body_duct, only: duct_type
    use body_faired, only: faired_type
    use body_ledger, only: joint_type
    use body_outline, only: outline_type
    use body_panel, only: panel_type
    use body_ring_list, only: ring_type
    use cut_clearance, only: clearance_type
    use cut_duct, only: duct_measure_type
    use cut_measure_body, only: body_measure_type
    use cut_offsets, only: offset_table_type
    use cut_outline, only: cut_type
    use deck_job, only: job_type
    use report_arc_listing, only: arc_table_type, print_arcs
    use report_clearance_listing, only: print_clearances
    use report_cut_listing, only: print_cut
    use report_duct_listing, only: print_ducts
    use report_faired_listing, only: print_faired
    use report_ledger_listing, only: print_ledger
    use report_measure_listing, only: print_measures
    use report_offset_listing, only: print_offsets
    use report_ordinate, only: new_form, ordinate_form_type
    use report_outline_listing, only: print_outline
    use report_page, only: page_type
    use report_patch_listing, only: print_patches
    use report_ring_listing, only: print_ring
    use report_title_page, only: print_title_page
    implicit none (type, external)
    private

    public :: body_listing_type

    !> Decimals that the tables of meetings, measures and clearances have room for.
    integer, parameter :: few_decimals = 3

    !> A listing being printed.
    type :: body_listing_type
        private
        type(page_type) :: page             !! its pages
        type(ordinate_form_type) :: form    !! unit and decimals of ordinates
        type(ordinate_form_type) :: coarse  !! of tables that have room for `few_decimals`
        integer :: cuts = 0                 !! cuts printed so far
    contains
        procedure :: begin
        procedure :: print_body_head
        procedure :: print_faired_lines
        procedure :: print_body_ring
        procedure :: print_body_patches
        procedure :: print_body_ducts
        procedure :: print_offset_tables
        procedure :: print_body_measures
        procedure :: print_body_clearances
        procedure :: print_body_cut
        procedure :: print_body_outline
        procedure :: print_body_arcs
    end type body_listing_type

contains

    !> Prints the title page.
    subroutine begin(listing, job, deck, out)
        class(body_listing_type), intent(inout) :: listing  !! the listing
        type(job_type), intent(in) :: job                   !! what the deck asks for
        character(*), intent(in) :: deck                    !! its name, without folders
        type(output_type), intent(inout) :: out             !! where it goes
        character(:), allocatable :: title

        title = 'CONIC LOFTING'
        if (allocated(job%title)) then
            if (job%title /= '') title = job%title
        end if
        listing%form = new_form(trim(job%units), trim(job%output), job%digits)
        listing%coarse = listing%form
        listing%coarse%decimals = min(listing%form%decimals, few_decimals)
        call listing%page%set_size(job%page_columns, job%page_lines)
        call listing%page%set_heading(title, deck, listing%form%unit)
        call print_title_page(listing%page, job, listing%form, out)
    end subroutine begin

    !> Prints the name of a body and the ledger of its lines.
    subroutine print_body_head(listing, body, joints, out)
        class(body_listing_type), intent(inout) :: listing  !! the listing
        type(body_type), intent(in) :: body                 !! the body
        type(joint_type), intent(in) :: joints(:)           !! of its lines
        type(output_type), intent(inout) :: out             !! where it goes

        if (body%name /= '') then
            call listing%page%keep(out, 6)
            call listing%page%line(out, 'BODY '//trim(body%name))
            call listing%page%blank(out)
        end if
        call print_ledger(listing%page, joints, listing%coarse, out)
    end subroutine print_body_head

    !> Prints what fairing did to the points of lines.
    subroutine print_faired_lines(listing, faired, out)
        class(body_listing_type), intent(inout) :: listing  !! the listing
        type(faired_type), intent(in) :: faired(:)          !! of a body
        type(output_type), intent(inout) :: out             !! where it goes
        call print_faired(listing%page, faired, listing%form, out)
    end subroutine print_faired_lines

    !> Prints how the sections of a body meet.
    subroutine print_body_ring(listing, body, ring, out)
        class(body_listing_type), intent(inout) :: listing  !! the listing
        type(body_type), intent(in) :: body                 !! the body
        type(ring_type), intent(in) :: ring                 !! of the body
        type(output_type), intent(inout) :: out             !! where it goes
        call print_ring(listing%page, body, ring, listing%coarse, out)
    end subroutine print_body_ring

    !> Prints the patches of a body; `panels` may have other panels too.
    subroutine print_body_patches(listing, panels, out)
        class(body_listing_type), intent(inout) :: listing  !! the listing
        type(panel_type), intent(in) :: panels(:)           !! of the body
        type(output_type), intent(inout) :: out             !! where they go
        call print_patches(listing%page, panels, listing%coarse, out)
    end subroutine print_body_patches

    !> Prints the ducts of a body.
    subroutine print_body_ducts(listing, ducts, measures, out)
        class(body_listing_type), intent(inout) :: listing  !! the listing
        type(duct_type), intent(in) :: ducts(:)             !! of the body
        type(duct_measure_type), intent(in) :: measures(:)  !! of each
        type(output_type), intent(inout) :: out             !! where they go
        call print_ducts(listing%page, ducts, measures, listing%form, out)
    end subroutine print_body_ducts

    !> Prints the tables of offsets.
    subroutine print_offset_tables(listing, heights, half_breadths, sections, out)
        class(body_listing_type), intent(inout) :: listing  !! the listing
        type(offset_table_type), intent(in) :: heights      !! on butt lines
        type(offset_table_type), intent(in) :: half_breadths !! on waterlines
        character(*), intent(in) :: sections(:)             !! names of the body's sections
        type(output_type), intent(inout) :: out             !! where they go
        call print_offsets(listing%page, heights, sections, listing%form, out)
        call print_offsets(listing%page, half_breadths, sections, listing%form, out)
    end subroutine print_offset_tables

    !> Prints areas, volume and centroid.
    subroutine print_body_measures(listing, measure, out)
        class(body_listing_type), intent(inout) :: listing  !! the listing
        type(body_measure_type), intent(in) :: measure      !! of a body
        type(output_type), intent(inout) :: out             !! where they go
        call print_measures(listing%page, measure, listing%coarse, out)
    end subroutine print_body_measures

    !> Prints the clearances of a body's components.
    subroutine print_body_clearances(listing, clearances, out)
        class(body_listing_type), intent(inout) :: listing  !! the listing
        type(clearance_type), intent(in) :: clearances(:)   !! of its components
        type(output_type), intent(inout) :: out             !! where they go
        call print_clearances(listing%page, clearances, listing%coarse, out)
    end subroutine print_body_clearances

    !> Prints the next cut.
    subroutine print_body_cut(listing, cut, sections, out)
        class(body_listing_type), intent(inout) :: listing  !! the listing
        type(cut_type), intent(in) :: cut                   !! the cut
        character(*), intent(in) :: sections(:)             !! names of the body's sections
        type(output_type), intent(inout) :: out             !! where it goes
        listing%cuts = listing%cuts + 1
        call print_cut(listing%page, listing%cuts, cut, sections, listing%form, out)
    end subroutine print_body_cut

    !> Prints the next faired outline; it is numbered as a cut.
    subroutine print_body_outline(listing, outline, out)
        class(body_listing_type), intent(inout) :: listing  !! the listing
        type(outline_type), intent(in) :: outline           !! faired
        type(output_type), intent(inout) :: out             !! where it goes
        listing%cuts = listing%cuts + 1
        call print_outline(listing%page, listing%cuts, outline, listing%form, out)
    end subroutine print_body_outline

    !> Prints the circular arcs of the cut printed last.
    subroutine print_body_arcs(listing, cut, tables, out)
        class(body_listing_type), intent(inout) :: listing  !! the listing
        type(cut_type), intent(in) :: cut                   !! the cut
        type(arc_table_type), intent(in) :: tables(:)       !! one a contour; none: none are asked
        type(output_type), intent(inout) :: out             !! where they go
        call print_arcs(listing%page, listing%cuts, cut, tables, listing%form, out)
    end subroutine print_body_arcs

end module report_body_listing
