package org.maestro.rats.security;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Who belongs to a secured site, and where its broker is.
 *
 * @param site its name on the bus
 * @param hosts names and addresses that the broker is reached by
 * @param controllers ids that may read everything
 * @param members ids of devices
 */
public record SiteUsers(
    String site, List<String> hosts, SortedSet<String> controllers, SortedSet<String> members) {

  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9._-]{0,62}");

  /**
   * @throws SecurityFilesException when a name is no level of a topic, or is both a member's and a
   *     controller's
   */
  public SiteUsers {
    hosts = List.copyOf(hosts);
    controllers = sorted(controllers);
    members = sorted(members);
    for (String name : Stream.concat(Stream.of(site), all(controllers, members)).toList()) {
      if (!NAME.matcher(name).matches()) {
        throw new SecurityFilesException(
            "\""
                + name
                + "\" is no name on the bus: letters, digits, '.', '_' and '-', at most 63");
      }
    }
    for (String both : controllers) {
      if (members.contains(both)) {
        throw new SecurityFilesException(
            "\"" + both + "\" cannot be both a member and a controller; rename one of them");
      }
    }
    if (hosts.isEmpty()) {
      throw new SecurityFilesException("A broker needs a host name; name one with --host");
    }
  }

  /** Members and controllers, by name. */
  public SortedSet<String> all() {
    TreeSet<String> all = new TreeSet<>(controllers);
    all.addAll(members);
    return all;
  }

  /** The same site with these as well. */
  SiteUsers and(Collection<String> moreControllers, Collection<String> moreMembers) {
    TreeSet<String> allControllers = new TreeSet<>(controllers);
    allControllers.addAll(moreControllers);
    TreeSet<String> allMembers = new TreeSet<>(members);
    allMembers.addAll(moreMembers);
    return new SiteUsers(site, hosts, allControllers, allMembers);
  }

  String text() {
    StringBuilder text = new StringBuilder("# Written by ./maestro secure\n");
    text.append("site ").append(site).append('\n');
    hosts.forEach(host -> text.append("host ").append(host).append('\n'));
    controllers.forEach(id -> text.append("controller ").append(id).append('\n'));
    members.forEach(id -> text.append("member ").append(id).append('\n'));
    return text.toString();
  }

  static SiteUsers parse(String text, String source) {
    String site = "";
    List<String> hosts = new ArrayList<>();
    TreeSet<String> controllers = new TreeSet<>();
    TreeSet<String> members = new TreeSet<>();
    int number = 0;
    for (String raw : text.lines().toList()) {
      number++;
      String line = raw.replaceFirst("#.*", "").strip();
      String[] words = line.split("\\s+");
      if (line.isEmpty()) {
        continue;
      }
      switch (words.length == 2 ? words[0] : "") {
        case "site" -> site = words[1];
        case "host" -> hosts.add(words[1]);
        case "controller" -> controllers.add(words[1]);
        case "member" -> members.add(words[1]);
        default ->
            throw new SecurityFilesException(
                "%s, line %d: \"%s\" names no site, host, controller or member"
                    .formatted(source, number, line));
      }
    }
    return new SiteUsers(site, hosts, controllers, members);
  }

  private static SortedSet<String> sorted(Collection<String> names) {
    return Collections.unmodifiableSortedSet(new TreeSet<>(names));
  }

  private static Stream<String> all(Collection<String> controllers, Collection<String> members) {
    return Stream.concat(controllers.stream(), members.stream());
  }
}
