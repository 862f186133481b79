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
 * The users of a secured site, and the hosts of its broker.
 *
 * @param site its name on the bus
 * @param hosts names and addresses that the broker is reached by
 * @param controllers ids that may read everything
 * @param members ids of devices
 * @param guests ids of who may only join the platform and ask there; the bus does not know them
 */
public record SiteUsers(
    String site,
    List<String> hosts,
    SortedSet<String> controllers,
    SortedSet<String> members,
    SortedSet<String> guests) {

  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9._-]{0,62}");

  /**
   * @throws SecurityFilesException when a name is no level of a topic, or is given to two kinds of
   *     users
   */
  public SiteUsers {
    hosts = List.copyOf(hosts);
    controllers = sorted(controllers);
    members = sorted(members);
    guests = sorted(guests);
    for (String name :
        Stream.of(Stream.of(site), controllers.stream(), members.stream(), guests.stream())
            .flatMap(names -> names)
            .toList()) {
      if (!NAME.matcher(name).matches()) {
        throw new SecurityFilesException(
            "\""
                + name
                + "\" is no name on the bus: letters, digits, '.', '_' and '-', at most 63");
      }
    }
    requireDistinct(controllers, members, "a member and a controller");
    requireDistinct(controllers, guests, "a guest and a controller");
    requireDistinct(members, guests, "a guest and a member");
    if (hosts.isEmpty()) {
      throw new SecurityFilesException("A broker needs a host name; name one with --host");
    }
  }

  private static void requireDistinct(
      SortedSet<String> some, SortedSet<String> others, String both) {
    for (String name : some) {
      if (others.contains(name)) {
        throw new SecurityFilesException(
            "\"" + name + "\" cannot be both " + both + "; rename one of them");
      }
    }
  }

  /** Members and controllers, by name: whom the bus knows. */
  public SortedSet<String> all() {
    return both(controllers, members);
  }

  /** Controllers and guests, by name: whose processes may be containers of the platform. */
  public SortedSet<String> containers() {
    return both(controllers, guests);
  }

  /** The same site with those of another one as well. */
  SiteUsers and(SiteUsers others) {
    return new SiteUsers(
        site,
        hosts,
        both(controllers, others.controllers),
        both(members, others.members),
        both(guests, others.guests));
  }

  /** The same site without those. */
  SiteUsers without(Collection<String> ids) {
    return new SiteUsers(
        site, hosts, without(controllers, ids), without(members, ids), without(guests, ids));
  }

  private static SortedSet<String> without(SortedSet<String> names, Collection<String> ids) {
    TreeSet<String> rest = new TreeSet<>(names);
    rest.removeAll(ids);
    return rest;
  }

  String text() {
    StringBuilder text = new StringBuilder("# Written by ./maestro secure\n");
    text.append("site ").append(site).append('\n');
    hosts.forEach(host -> text.append("host ").append(host).append('\n'));
    controllers.forEach(id -> text.append("controller ").append(id).append('\n'));
    members.forEach(id -> text.append("member ").append(id).append('\n'));
    guests.forEach(id -> text.append("guest ").append(id).append('\n'));
    return text.toString();
  }

  static SiteUsers parse(String text, String source) {
    String site = "";
    List<String> hosts = new ArrayList<>();
    TreeSet<String> controllers = new TreeSet<>();
    TreeSet<String> members = new TreeSet<>();
    TreeSet<String> guests = new TreeSet<>();
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
        case "guest" -> guests.add(words[1]);
        default ->
            throw new SecurityFilesException(
                "%s, line %d: \"%s\" names no site, host, controller, member or guest"
                    .formatted(source, number, line));
      }
    }
    return new SiteUsers(site, hosts, controllers, members, guests);
  }

  private static SortedSet<String> sorted(SortedSet<String> names) {
    return Collections.unmodifiableSortedSet(new TreeSet<>(names));
  }

  private static SortedSet<String> both(SortedSet<String> some, SortedSet<String> others) {
    TreeSet<String> both = new TreeSet<>(some);
    both.addAll(others);
    return both;
  }
}
