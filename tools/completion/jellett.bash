# Completion of jellett and ttc in bash: what share/jellett/complete says beside the program that is typed.
_jellett() {
    local before=${COMP_LINE:0:COMP_POINT} words program line candidate cut=
    COMPREPLY=()
    read -ra words <<< "$before"
    [[ $before != *[[:blank:]] ]] || words+=('')
    program=$(readlink -f "$(type -P "${words[0]}")") || return
    # Readline looks at what follows the last of these alone.
    [[ ${words[-1]} != *[=:]* ]] || cut=${words[-1]%"${words[-1]##*[=:]}"}
    while IFS= read -r line; do
        candidate=${line%%$'\t'*}
        case $candidate in
            @files* | @folders)
                compopt -o filenames 2> /dev/null
                local names=(-f -X "!${candidate#@files }")
                [[ $candidate != *' *.'* ]] || mapfile -O ${#COMPREPLY[@]} -t COMPREPLY < <(compgen -d -- "${words[-1]#"$cut"}")
                [[ $candidate != @folders ]] || names=(-d)
                mapfile -O ${#COMPREPLY[@]} -t COMPREPLY < <(compgen "${names[@]}" -- "${words[-1]#"$cut"}") ;;
            *=) compopt -o nospace 2> /dev/null; COMPREPLY+=("${candidate#"$cut"}") ;;
            *) COMPREPLY+=("${candidate#"$cut"}") ;;
        esac
    done < <("${program%/*}/../share/jellett/complete" "$program" "${words[@]:1}")
}
complete -F _jellett jellett ttc
