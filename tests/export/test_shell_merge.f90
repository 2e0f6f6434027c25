!> Skins of several bodies put together: every reference finds what it found before.
program test_shell_merge
    use base_kinds, only: dp
    use export_shell, only: side_type, skin_model_type
    use export_shell_merge, only: append_model
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(skin_model_type) :: model, none
    integer :: i
    logical :: is_sound

    allocate (none%vertices(0), none%edges(0), none%faces(0), none%shells(0))
    call append_model(model, body(1.0_dp))
    call tap%ok(sees(model, 1, 1.0_dp), 'the first skin is as it was')
    call append_model(model, none)
    call append_model(model, body(2.0_dp))
    call append_model(model, body(3.0_dp))
    call tap%ok(all([size(model%vertices), size(model%edges), size(model%faces), &
        size(model%shells)] == [9, 6, 6, 3]), 'three skins of two faces are six faces')
    is_sound = .true.
    do i = 1, 3
        is_sound = is_sound .and. sees(model, i, real(i, dp))
    end do
    call tap%ok(is_sound, 'each has the edges and corners it had')
    call tap%ok(model%shells(3)%is_closed .and. all(model%shells(3)%faces == [5, 6]), &
        'shells have their faces')
    call tap%ok(model%faces(6)%sides(2)%edge == 0 .and. model%faces(6)%sides(2)%vertex == 9, &
        'a side that is a point has its vertex')
    call tap%finish()

contains

    !> A made-up skin: three vertices, two edges, two faces, one shell.
    function body(mark)
        real(dp), intent(in) :: mark !! STA of its vertices
        type(skin_model_type) :: body
        integer :: i
        allocate (body%vertices(3), body%edges(2), body%faces(2), body%shells(1))
        do i = 1, 3
            body%vertices(i)%at = [mark, real(i, dp), 0.0_dp]
        end do
        body%edges(1)%from = 1
        body%edges(1)%to = 2
        body%edges(2)%from = 2
        body%edges(2)%to = 3
        do i = 1, 2
            allocate (body%faces(i)%sides(2))
            body%faces(i)%name = 'F'
            body%faces(i)%sides(1) = side_type(edge=i)
            body%faces(i)%sides(2) = side_type(edge=0, vertex=3)
        end do
        allocate (body%shells(1)%faces(2))
        body%shells(1)%faces = [1, 2]
        body%shells(1)%is_closed = .true.
    end function body

    !> True where the faces of a shell lead to vertices with its mark.
    logical function sees(model, shell, mark)
        type(skin_model_type), intent(in) :: model  !! several skins
        integer, intent(in) :: shell                !! which
        real(dp), intent(in) :: mark                !! STA of its vertices
        integer :: i
        sees = .true.
        do i = 1, 2
            associate (face => model%faces(model%shells(shell)%faces(i)))
                associate (edge => model%edges(face%sides(1)%edge))
                    sees = sees .and. all(abs(model%vertices(edge%from)%at - &
                        [mark, real(i, dp), 0.0_dp]) <= 0.0_dp) .and. &
                        all(abs(model%vertices(edge%to)%at - [mark, real(i + 1, dp), 0.0_dp]) <= &
                        0.0_dp) .and. &
                        abs(model%vertices(face%sides(2)%vertex)%at(1) - mark) <= 0.0_dp
                end associate
            end associate
        end do
    end function sees

end program test_shell_merge
