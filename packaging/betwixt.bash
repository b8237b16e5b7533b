# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
_betwixt() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]} words
  if [ "$COMP_CWORD" = 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W 'play render frame eval plot check tidy algebra contacts serve shell help --help --version' -- "$current")
    return
  fi
  case $previous in
    --style) words='shaded wireframe hidden-line' ;;
    --samples) words='1 4 9 16' ;;
    --size) words='320x180 640x360 960x540 1280x720 1920x1080 3840x2160' ;;
    --at | --frames | --jobs | --listen | --steps | --points | --origin) return ;;
    --method) words='matrix geometric differences best' ;;
    -o | --output | --record | --lesson)
      mapfile -t COMPREPLY < <(compgen -f -- "$current")
      return
      ;;
  esac
  if [ -z "$words" ] && [[ $current == -* ]]; then
    case $command in
      render) words='-o --output --frames --size --style --samples --jobs --no-overwrite --stats' ;;
      frame) words='-o --output --at --size --style --samples --no-overwrite' ;;
      play) words='--terminal --frames --loop --listen --record --overwrite --size --style --samples' ;;
      eval) words='--at --json' ;;
      plot) words='-o --output --frames' ;;
      tidy) words='--write' ;;
      algebra) words='--steps --at --points --method --count --css --origin --to-css --lesson --inverse --json' ;;
      contacts) words='--frames --swept --related' ;;
      serve) words='--socket --tcp --anywhere --token-file --to --rate --size --style --samples --class --sweep --wait --latency --save --overwrite --hosts --ceiling' ;;
      shell) words='--recover --discard' ;;
    esac
    words+=' --read-anywhere --load --help'
  fi
  if [ -n "$words" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -f -X '!*.bx' -- "$current"; compgen -d -- "$current")
  fi
}
complete -o filenames -F _betwixt betwixt
