!> What outlines on panels are called: by the panels that they are on.
program test_panel_words
    use cut_outline, only: cut_type, outline_type
    use report_panel_words, only: kind_word, panels_word
    use support_tap, only: tap_type
    implicit none (type, external)

    type(tap_type) :: tap
    type(cut_type) :: cut

    cut%sections = 2
    cut%patches = 3
    call tap%same(trim(kind_word(cut, 2))//' '//trim(kind_word(cut, 3))//' '// &
        trim(kind_word(cut, 5))//' '// &
        trim(kind_word(cut, 6)), 'SECTION PATCH PATCH DUCT', 'sections, then patches, then ducts')
    call tap%same(words_on([3]), 'PATCHES', 'on patches')
    call tap%same(words_on([6, 7]), 'DUCTS', 'on ducts')
    call tap%same(words_on([5, 6]), 'PATCHES AND DUCTS', 'on both')
    call tap%finish()

contains

    !> The words of a cut with outlines on some panels.
    function words_on(panels) result(words)
        integer, intent(in) :: panels(:) !! of one point each
        character(:), allocatable :: words
        type(cut_type) :: met
        integer :: i
        met = cut
        allocate (met%patched(size(panels)))
        do i = 1, size(panels)
            allocate (met%patched(i)%points(1))
            met%patched(i)%points(1)%section = panels(i)
        end do
        words = trim(panels_word(met))
    end function words_on

end program test_panel_words
