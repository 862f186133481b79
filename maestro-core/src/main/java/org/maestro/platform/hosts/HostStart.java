package org.maestro.platform.hosts;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The start of a container's process on its host, again and again if need be (ADE, 3.2; A35-A37).
 *
 * @param name of the container
 * @param topics whose agents it is for
 * @param provides what its host has
 * @param command a program and its arguments, in which {@code {main}}, {@code {name}}, {@code
 *     {topics}} and {@code {provides}} stand for what is known only later; no shell reads it here
 */
public record HostStart(
    String name, Set<String> topics, Set<String> provides, List<String> command) {
  private static final Pattern PLACE = Pattern.compile("\\{([a-z]+)\\}");
  static final Set<String> PLACES = new TreeSet<>(List.of("main", "name", "provides", "topics"));

  public HostStart {
    topics = new TreeSet<>(topics);
    provides = new TreeSet<>(provides);
    command = List.copyOf(command);
  }

  /** What stands in braces in the command, whether it is known or not. */
  List<String> places() {
    return command.stream()
        .flatMap(word -> PLACE.matcher(word).results())
        .map(found -> found.group(1))
        .toList();
  }

  /**
   * The command as it is to be run. What says only that there is nothing, such as {@code --topic=}
   * of a host without topics, is left away.
   *
   * @param main {@code HOST:PORT} of the main container
   */
  public List<String> command(String main) {
    Map<String, String> values =
        Map.of(
            "main",
            main,
            "name",
            name,
            "topics",
            String.join(",", topics),
            // A shell at the other end of the line would take a blank for the end of a word.
            "provides",
            String.join(",", provides).replace(' ', '='));
    return command.stream()
        .map(word -> filled(word, values))
        .filter(word -> !word.endsWith("="))
        .toList();
  }

  private static String filled(String word, Map<String, String> values) {
    return PLACE
        .matcher(word)
        .replaceAll(
            place -> Matcher.quoteReplacement(values.getOrDefault(place.group(1), place.group())));
  }
}
