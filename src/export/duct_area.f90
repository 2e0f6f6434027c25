!> The area curve of a duct: the areas of its sections over the stations, those of the outlines and
!> of the cuts marked.
module export_duct_area
    use base_kinds, only: dp
    use body_duct, only: duct_type
    use cut_duct, only: duct_measure_type
    use export_body_area, only: figures
    use export_body_drawing, only: drawing_type, mark_of, word_side
    use geom_fairing_system, only: spline_area
    use geom_ring_loft, only: ring_at
    implicit none (type, external)
    private

    public :: duct_area_drawing

    !> Dots of the box between the axes.
    real(dp), parameter :: box(2) = [760.0_dp, 400.0_dp]
    !> Points of the curve: more than the eye can tell.
    integer, parameter :: points = 361
    !> Room above the curve, in parts of its height.
    real(dp), parameter :: margin = 0.12_dp
    !> Dots from a point to its words, upwards.
    real(dp), parameter :: above = 12.0_dp

contains

    !> The picture of the areas of a duct.
    pure type(drawing_type) function duct_area_drawing(duct, measure, heading, unit) &
        result(drawing)
        type(duct_type), intent(in) :: duct             !! as built
        type(duct_measure_type), intent(in) :: measure  !! of it
        character(*), intent(in) :: heading             !! title of the deck
        character(*), intent(in) :: unit                !! name of its unit
        real(dp) :: curve(2, points)
        integer :: i

        associate (ends => duct%outline%sta)
            do i = 1, points
                curve(1, i) = ends(1) + real(i - 1, dp)/real(points - 1, dp) &
                    *(ends(size(ends)) - ends(1))
                curve(2, i) = spline_area(ring_at(duct%loft, curve(1, i)), .true.)
            end do
        end associate
        drawing%script = 'chart'
        drawing%heading = heading
        drawing%note = ''
        drawing%view = 'Section areas of duct '//trim(duct%name)//'; volume '// &
            figures(measure%volume)//' cubic '//unit
        drawing%x_axis = 'station (STA), '//unit
        drawing%y_axis = 'area of the section, square '//unit
        drawing%low = [curve(1, 1), 0.0_dp]
        drawing%high = [curve(1, points), (1.0_dp + margin)*maxval(curve(2, :))]
        drawing%dot = (drawing%high - drawing%low)/box
        call drawing%draw('curve', curve)
        do i = 1, size(measure%section)
            call mark_section(duct, measure, i, drawing)
        end do
    end function duct_area_drawing

    !> Marks a section on the curve; an outline has its name, another section its station.
    pure subroutine mark_section(duct, measure, number, drawing)
        type(duct_type), intent(in) :: duct             !! as built
        type(duct_measure_type), intent(in) :: measure  !! of it
        integer, intent(in) :: number                   !! of the section
        type(drawing_type), intent(inout) :: drawing    !! gets the mark
        character(:), allocatable :: words
        integer :: side

        associate (section => measure%section(number))
            call drawing%draw('point', reshape([section%sta, section%area], [2, 1]))
            words = mark_of(section%sta)
            if (section%outline > 0) words = trim(duct%outline(section%outline)%name)//' '//words
            side = word_side%middle
            if (number == 1) side = word_side%right
            if (number == size(measure%section)) side = word_side%left
            call drawing%write_where_free(words, reshape([section%sta, section%area &
                + above*drawing%dot(2)], [2, 1]), side)
        end associate
    end subroutine mark_section

end module export_duct_area
