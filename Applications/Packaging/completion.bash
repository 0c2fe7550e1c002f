# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of pemesh and pemesh-vem in bash: subcommands and options are what --help names.

# Prints the words of a section of the help of "$2..." that match the pattern $1.
_pemesh_words()
{
  local pattern=$1
  shift
  "$@" --help 2>/dev/null | sed -nE "$pattern"
}

_pemesh()
{
  local current=${COMP_WORDS[COMP_CWORD]} program=${COMP_WORDS[0]} subcommand="" word
  local -a command=("$program")
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    if [[ $word == [a-z]* ]]; then
      subcommand=$word
      command+=("$word")
      break
    fi
  done
  COMPREPLY=()
  if [[ $current == -* ]]; then
    # "  -o,--output TEXT   Folder ..." holds --output
    mapfile -t COMPREPLY < <(compgen -W \
      "$(_pemesh_words 's/^  (-[A-Za-z],)?(--[a-z0-9-]+).*/\2/p' "${command[@]}")" -- "$current")
  elif [[ -z $subcommand && $program == *pemesh ]]; then
    mapfile -t COMPREPLY < <(compgen -W \
      "$(_pemesh_words '/^Subcommands:/,$s/^  ([a-z]+) .*/\1/p' "$program")" -- "$current")
  fi
  [[ ${#COMPREPLY[@]} -gt 0 ]] || compopt -o default 2>/dev/null # names of files
}

complete -F _pemesh pemesh pemesh-vem
