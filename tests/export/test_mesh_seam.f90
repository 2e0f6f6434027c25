!> Tests of runs joined where their sections change.
program test_mesh_seam
    use base_kinds, only: dp
    use body_body, only: body_type
    use export_mesh_row, only: first_row
    use export_mesh_seam, only: join_row
    use support_cylinders, only: cylinders, split_cylinder
    use support_laid, only: laid, laid_type
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(body_type) :: body
    type(laid_type) :: it
    integer, allocatable :: both(:)
    integer :: row, before, n(2)

    ! Sections: LOF all along, UPF to the stop, UPA and UPB from it.
    body = split_cylinder()
    it = laid(body, 0.05_dp)
    row = first_row(it%plan, 2)
    before = it%mesh%vertex_count
    call join_row([1, 2], [1, 3, 4], 1.0e-6_dp, it%rows(row), it%mesh)
    associate (strands => it%rows(row)%strands)
        both = [strands(3)%vertex, strands(4)%vertex(2:)]
        call tap%ok(size(both) == size(strands(2)%vertex), &
            'a section that goes on as two: both sides have the same vertices')
        call tap%ok(all(both == strands(2)%vertex), 'in the same order')
        call tap%ok(any(strands(2)%vertex(2:size(both) - 1) == strands(4)%vertex(1)), &
            'the line between the two is one of them')
        call tap%ok(is_rising(strands(2)%share) .and. is_rising(strands(3)%share) .and. &
            is_rising(strands(4)%share), 'their shares rise')
        call tap%near(largest_off(), 0.0_dp, 1.0e-12_dp, 'all are on the circle')
        call tap%ok(least_step() > 0.25_dp/real(size(both), dp)*50.0_dp, 'none is a needle')
        call tap%ok(it%mesh%vertex_count == before, 'no vertex is new')
    end associate

    ! Ellipses 50 by 30 and 30 by 50 cross where BL is WL: at 1500/sqrt(3400) in both quarters.
    body = cylinders([50.0_dp, 30.0_dp], [30.0_dp, 50.0_dp], 0.0_dp)
    it = laid(body, 0.05_dp)
    row = first_row(it%plan, 2)
    before = it%mesh%vertex_count
    n = [size(it%rows(row)%strands(1)%vertex), size(it%rows(row)%strands(3)%vertex)]
    call join_row([1, 2], [3, 4], 1.0e-6_dp, it%rows(row), it%mesh)
    call tap%ok(it%mesh%vertex_count == before + 2, 'outlines that cross get a vertex there')
    call tap%ok(all([size(it%rows(row)%strands(1)%vertex), &
        size(it%rows(row)%strands(3)%vertex)] == n + 1), 'each of both')
    call tap%ok(any(it%rows(row)%strands(3)%vertex == before + 1) .and. &
        any(it%rows(row)%strands(1)%vertex == before + 1), 'the same')
    call tap%near(norm2(abs(it%mesh%vertices(2:, before + 1)) - 1500.0_dp/sqrt(3400.0_dp)), &
        0.0_dp, 0.1_dp, 'where they cross')
    call tap%ok(is_rising(it%rows(row)%strands(1)%share), 'in its order')

    ! A step: nothing in common.
    body = cylinders([50.0_dp, 50.0_dp], [30.0_dp, 30.0_dp], 0.0_dp)
    it = laid(body, 0.05_dp)
    before = it%mesh%vertex_count
    row = first_row(it%plan, 2)
    n = [size(it%rows(row)%strands(1)%vertex), size(it%rows(row)%strands(3)%vertex)]
    call join_row([1, 2], [3, 4], 1.0e-6_dp, it%rows(row), it%mesh)
    call tap%ok(it%mesh%vertex_count == before .and. all([size(it%rows(row)%strands(1)%vertex), &
        size(it%rows(row)%strands(3)%vertex)] == n), 'outlines apart stay as they are')
    ! The same curve, of which one side has other columns.
    body = cylinders([50.0_dp, 50.0_dp], [50.0_dp, 50.0_dp], 0.0_dp)
    it = laid(body, 0.05_dp)
    row = first_row(it%plan, 2)
    associate (strand => it%rows(row)%strands(3))
        strand%vertex = strand%vertex([1, 4, size(strand%vertex)])
        strand%share = strand%share([1, 4, size(strand%share)])
        strand%t = strand%t([1, 4, size(strand%t)])
    end associate
    call join_row([1, 2], [3, 4], 1.0e-6_dp, it%rows(row), it%mesh)
    call tap%ok(size(it%rows(row)%strands(3)%vertex) == size(it%rows(row)%strands(1)%vertex), &
        'a coarse strand takes the vertices of a fine one')
    call tap%ok(all(it%rows(row)%strands(3)%vertex == it%rows(row)%strands(1)%vertex), &
        'and gives its own for them')
    call tap%finish()

contains

    !> True for numbers that rise.
    logical function is_rising(share)
        real(dp), intent(in) :: share(:)
        is_rising = all(share(2:) > share(:size(share) - 1))
    end function is_rising

    !> How far the joined vertices are from the circle.
    real(dp) function largest_off()
        largest_off = maxval(abs(norm2(it%mesh%vertices(2:, both), dim=1) - 50.0_dp))
    end function largest_off

    !> The shortest way from one to the next.
    real(dp) function least_step()
        least_step = minval(norm2(it%mesh%vertices(2:, both(2:)) &
            - it%mesh%vertices(2:, both(:size(both) - 1)), dim=1))
    end function least_step

end program test_mesh_seam
