package org.maestro.rats.security;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.maestro.rats.member.CallPolicy;

/**
 * A secured site's rules of who may call which feature of whom, from its file {@code rules}: lines
 * {@code allow CALLER MEMBER FEATURE}. What no line allows is refused.
 */
public final class CallRules implements CallPolicy {

  static final String USUAL =
      """
      # Who may call which feature of whom on this site. What no line allows is refused.
      #
      #   allow CALLER MEMBER FEATURE
      #
      # CALLER and MEMBER are a user of this site, @members, @controllers, or * for everybody.
      # FEATURE is a feature, or * for all. Whoever called may also cancel what it called.
      allow @controllers * *
      allow @members @controllers $offer
      allow @members @controllers $release
      allow * * $ping
      """;

  private static final String ANYBODY = "*";
  private static final String MEMBERS = "@members";
  private static final String CONTROLLERS = "@controllers";

  private record Line(String caller, String member, String feature) {}

  private final SiteUsers users;
  private final List<Line> lines;

  private CallRules(SiteUsers users, List<Line> lines) {
    this.users = users;
    this.lines = List.copyOf(lines);
  }

  /**
   * @param source where the text is from, for messages
   * @throws SecurityFilesException at the first line that is none, or names nobody of the site
   */
  static CallRules parse(String text, String source, SiteUsers users) {
    List<Line> lines = new ArrayList<>();
    int number = 0;
    for (String raw : text.lines().toList()) {
      number++;
      String line = raw.replaceFirst("#.*", "").strip();
      if (!line.isEmpty()) {
        String[] words = line.split("\\s+");
        if (words.length != 4 || !words[0].equals("allow")) {
          throw new SecurityFilesException(
              "%s, line %d: \"%s\" is no rule; write: allow CALLER MEMBER FEATURE"
                  .formatted(source, number, line));
        }
        requireKnown(words[1], source, number, users);
        requireKnown(words[2], source, number, users);
        lines.add(new Line(words[1], words[2], words[3]));
      }
    }
    return new CallRules(users, lines);
  }

  /** The text of rules in which no line names one of those any more. */
  static String without(Collection<String> ids, String text) {
    return text.lines()
            .map(line -> isAbout(ids, line) ? "# revoked: " + line : line)
            .collect(Collectors.joining("\n"))
        + "\n";
  }

  private static boolean isAbout(Collection<String> ids, String line) {
    String[] words = line.replaceFirst("#.*", "").strip().split("\\s+");
    return words.length > 2 && (ids.contains(words[1]) || ids.contains(words[2]));
  }

  @Override
  public boolean allows(String caller, String member, String feature) {
    return lines.stream()
        .anyMatch(
            line ->
                means(line.caller, caller)
                    && means(line.member, member)
                    && (line.feature.equals(ANYBODY) || line.feature.equals(feature)));
  }

  @Override
  public boolean isSecured() {
    return true;
  }

  private boolean means(String word, String user) {
    return switch (word) {
      case ANYBODY -> users.all().contains(user);
      case MEMBERS -> users.members().contains(user);
      case CONTROLLERS -> users.controllers().contains(user);
      default -> word.equals(user);
    };
  }

  private static void requireKnown(String word, String source, int line, SiteUsers users) {
    if (!Set.of(ANYBODY, MEMBERS, CONTROLLERS).contains(word) && !users.all().contains(word)) {
      throw new SecurityFilesException(
          "%s, line %d: the site has no user \"%s\"; ./maestro secure DIR --member %s adds one"
              .formatted(source, line, word, word));
    }
  }
}
