!> Measures of a duct: area, perimeter and centroid of its sections, the volume within. All of a
!> duct, never of half of it; of one that has a mirror image, without that.
module cut_duct
    use base_error, only: error_type
    use base_exact, only: is_equal
    use base_kinds, only: dp
    use base_order, only: rising
    use body_duct, only: duct_type
    use cut_faired, only: ring_length
    use geom_fairing_system, only: spline_area
    use geom_ring_loft, only: ring_at, ring_loft_volume
    use geom_ring_spline, only: ring_centroid
    implicit none (type, external)
    private

    public :: duct_measure_type, duct_section_type, measure_duct, measure_duct_at

    !> A section of a duct.
    type :: duct_section_type
        real(dp) :: sta = 0.0_dp            !! deck units
        integer :: outline = 0              !! the outline that it is; 0: none
        real(dp) :: area = 0.0_dp           !! deck units squared, exact but for rounding
        real(dp) :: centroid(2) = 0.0_dp    !! BL and WL of the area, deck units
        logical :: has_perimeter = .false.  !! quadrature could measure it
        real(dp) :: perimeter = 0.0_dp      !! deck units
    end type duct_section_type

    !> What a duct measures.
    type :: duct_measure_type
        type(duct_section_type), allocatable :: section(:)  !! STA rising
        real(dp) :: volume = 0.0_dp                         !! deck units cubed
    end type duct_measure_type

contains

    !> Measures a duct at its outlines and at the stations that it has of some.
    pure type(duct_measure_type) function measure_duct(duct, stations) result(measure)
        type(duct_type), intent(in) :: duct         !! as built
        real(dp), intent(in) :: stations(:)         !! in any order, deck units
        real(dp), allocatable :: sta(:)
        integer :: i

        allocate (sta(0))
        associate (ends => duct%outline%sta)
            sta = rising([ends, pack(stations, stations > ends(1) .and. &
                stations < ends(size(ends)))])
            allocate (measure%section(size(sta)))
            do i = 1, size(sta)
                call measure_duct_at(duct, sta(i), measure%section(i))
                measure%section(i)%outline = findloc(is_equal(ends, sta(i)), .true., dim=1)
            end do
        end associate
        measure%volume = ring_loft_volume(duct%loft)
    end function measure_duct

    !> Measures the section of a duct at a station.
    pure subroutine measure_duct_at(duct, sta, section)
        type(duct_type), intent(in) :: duct             !! as built
        real(dp), intent(in) :: sta                     !! from its first outline to its last
        type(duct_section_type), intent(out) :: section !! what it measures
        real(dp), allocatable :: ring(:, :)
        type(error_type), allocatable :: error

        allocate (ring, source=ring_at(duct%loft, sta))
        section%sta = sta
        section%area = spline_area(ring, .true.)
        section%centroid = ring_centroid(ring)
        call ring_length(ring, section%perimeter, error)
        section%has_perimeter = .not. allocated(error)
    end subroutine measure_duct_at

end module cut_duct
