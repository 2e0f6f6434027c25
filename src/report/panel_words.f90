!> What the panels are called on the pages of a cut: patches, ducts, or both.
module report_panel_words
    use cut_outline, only: cut_type
    implicit none (type, external)
    private

    public :: kind_word, panels_word

contains

    !> SECTION, PATCH or DUCT: what the points of a number are of.
    pure function kind_word(cut, section) result(word)
        type(cut_type), intent(in) :: cut   !! the cut
        integer, intent(in) :: section      !! of a point
        character(7) :: word
        word = 'DUCT'
        if (section <= cut%sections) then
            word = 'SECTION'
        else if (section <= cut%sections + cut%patches) then
            word = 'PATCH'
        end if
    end function kind_word

    !> What the outlines on panels are on.
    pure function panels_word(cut) result(words)
        type(cut_type), intent(in) :: cut   !! with outlines on panels
        character(17) :: words
        logical :: has_patch, has_duct
        integer :: i

        has_patch = .false.
        has_duct = .false.
        do i = 1, size(cut%patched)
            if (kind_word(cut, cut%patched(i)%points(1)%section) == 'DUCT') then
                has_duct = .true.
            else
                has_patch = .true.
            end if
        end do
        words = 'PATCHES'
        if (has_duct) words = 'DUCTS'
        if (has_duct .and. has_patch) words = 'PATCHES AND DUCTS'
    end function panels_word

end module report_panel_words
