package org.maestro.troubleshooting;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * The page: what is written by hand, and in each of its places the messages of the packages and
 * classes that the place names.
 */
final class TroubleshootingPage {
  private static final Pattern PLACE =
      Pattern.compile("<!-- messages of ([^>]+?) -->\n.*?<!-- end of messages -->", Pattern.DOTALL);

  private final Kinds kinds;
  private final Collection<Message> messages;

  TroubleshootingPage(Kinds kinds, Collection<Message> messages) {
    this.kinds = kinds;
    this.messages = messages;
  }

  /** The page with all that is between the marks made anew. */
  String current(String page) {
    Map<String, List<Message>> placed = placed(page);
    return PLACE
        .matcher(page)
        .replaceAll(
            place ->
                Matcher.quoteReplacement(
                    "<!-- messages of %s -->\n%s\n<!-- end of messages -->"
                        .formatted(
                            place.group(1), list(placed.getOrDefault(place.group(1), List.of())))));
  }

  /** The packages whose messages have no place on the page. */
  SortedSet<String> homeless(String page) {
    List<String> places = places(page);
    return messages.stream()
        .map(Message::where)
        .filter(where -> place(where, places).isEmpty())
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private Map<String, List<Message>> placed(String page) {
    List<String> places = places(page);
    Map<String, List<Message>> placed = new LinkedHashMap<>();
    for (Message message : messages) {
      place(message.where(), places)
          .ifPresent(place -> placed.computeIfAbsent(place, key -> new ArrayList<>()).add(message));
    }
    return placed;
  }

  private static List<String> places(String page) {
    return PLACE.matcher(page).results().map(place -> place.group(1)).toList();
  }

  /** The place that names the class, or the package nearest to it. */
  private static Optional<String> place(String where, List<String> places) {
    return places.stream()
        .filter(place -> nearness(where, place) > 0)
        .max(Comparator.comparingInt(place -> nearness(where, place)));
  }

  private static int nearness(String where, String place) {
    return Pattern.compile(", ")
        .splitAsStream(place)
        .filter(name -> where.equals(name) || where.startsWith(name + "."))
        .mapToInt(String::length)
        .max()
        .orElse(0);
  }

  private String list(List<Message> said) {
    Map<String, SortedSet<String>> texts =
        new TreeMap<>(Comparator.comparingInt(kinds::rank).thenComparing(kinds::heading));
    for (Message message : said) {
      texts.computeIfAbsent(message.kind(), kind -> new TreeSet<>()).add(item(message.text()));
    }
    return texts.entrySet().stream()
        .map(one -> kinds.heading(one.getKey()) + "\n\n" + String.join("\n", one.getValue()))
        .collect(Collectors.joining("\n\n"));
  }

  private static String item(String text) {
    return text.contains("`") ? "- `` " + text + " ``" : "- `" + text + "`";
  }
}
