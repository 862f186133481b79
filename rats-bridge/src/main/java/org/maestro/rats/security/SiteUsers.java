package org.maestro.rats.security;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
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
 * @param observers ids of who may read everything and say nothing, as the console does
 * @param guests ids of who may only join the platform and ask there; the bus does not know them
 * @param persons who may sign in at the console, each with a role; they may be controllers or
 *     guests, too
 */
public record SiteUsers(
    String site,
    List<String> hosts,
    SortedSet<String> controllers,
    SortedSet<String> members,
    SortedSet<String> observers,
    SortedSet<String> guests,
    SortedMap<String, Role> persons) {

  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9._-]{0,62}");

  /**
   * @throws SecurityFilesException when a name is no level of a topic, or is given to two kinds of
   *     users
   */
  public SiteUsers {
    hosts = List.copyOf(hosts);
    controllers = sorted(controllers);
    members = sorted(members);
    observers = sorted(observers);
    guests = sorted(guests);
    persons = Collections.unmodifiableSortedMap(new TreeMap<>(persons));
    for (String name :
        Stream.of(
                Stream.of(site),
                controllers.stream(),
                members.stream(),
                observers.stream(),
                guests.stream(),
                persons.keySet().stream())
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
    requireDistinct(controllers, observers, "an observer and a controller");
    requireDistinct(members, observers, "an observer and a member");
    requireDistinct(controllers, guests, "a guest and a controller");
    requireDistinct(members, guests, "a guest and a member");
    requireDistinct(members, persons.keySet(), "a person at the console and a member");
    if (hosts.isEmpty()) {
      throw new SecurityFilesException("A broker needs a host name; name one with --host");
    }
  }

  private static void requireDistinct(
      SortedSet<String> some, Collection<String> others, String both) {
    for (String name : some) {
      if (others.contains(name)) {
        throw new SecurityFilesException(
            "\"" + name + "\" cannot be both " + both + "; rename one of them");
      }
    }
  }

  /** Members, controllers and observers, by name: whom the bus knows. */
  public SortedSet<String> all() {
    return both(both(controllers, members), observers);
  }

  /** Controllers and guests, by name: whose processes may be containers of the platform. */
  public SortedSet<String> containers() {
    return both(controllers, guests);
  }

  /** Whether it knows somebody of that name. */
  boolean has(String id) {
    return all().contains(id) || containers().contains(id) || persons.containsKey(id);
  }

  /** The same site with those of another one as well; persons have their roles here. */
  SiteUsers and(SiteUsers others) {
    SortedMap<String, Role> allPersons = new TreeMap<>(others.persons);
    allPersons.putAll(persons);
    return new SiteUsers(
        site,
        hosts,
        both(controllers, others.controllers),
        both(members, others.members),
        both(observers, others.observers),
        both(guests, others.guests),
        allPersons);
  }

  /** The same site without those. */
  SiteUsers without(Collection<String> ids) {
    SortedMap<String, Role> rest = new TreeMap<>(persons);
    rest.keySet().removeAll(ids);
    return new SiteUsers(
        site,
        hosts,
        without(controllers, ids),
        without(members, ids),
        without(observers, ids),
        without(guests, ids),
        rest);
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
    observers.forEach(id -> text.append("observer ").append(id).append('\n'));
    guests.forEach(id -> text.append("guest ").append(id).append('\n'));
    persons.forEach((id, role) -> text.append(role.word()).append(' ').append(id).append('\n'));
    return text.toString();
  }

  static SiteUsers parse(String text, String source) {
    String site = "";
    List<String> hosts = new ArrayList<>();
    TreeSet<String> controllers = new TreeSet<>();
    TreeSet<String> members = new TreeSet<>();
    TreeSet<String> observers = new TreeSet<>();
    TreeSet<String> guests = new TreeSet<>();
    TreeMap<String, Role> persons = new TreeMap<>();
    int number = 0;
    for (String raw : text.lines().toList()) {
      number++;
      String line = raw.replaceFirst("#.*", "").strip();
      String[] words = line.split("\\s+");
      if (line.isEmpty()) {
        continue;
      }
      Optional<Role> role = words.length == 2 ? Role.of(words[0]) : Optional.empty();
      if (role.isPresent()) {
        if (persons.put(words[1], role.get()) != null) {
          throw new SecurityFilesException(
              "%s, line %d: %s has another role above; leave one of them"
                  .formatted(source, number, words[1]));
        }
        continue;
      }
      switch (words.length == 2 ? words[0] : "") {
        case "site" -> site = words[1];
        case "host" -> hosts.add(words[1]);
        case "controller" -> controllers.add(words[1]);
        case "member" -> members.add(words[1]);
        case "observer" -> observers.add(words[1]);
        case "guest" -> guests.add(words[1]);
        default ->
            throw new SecurityFilesException(
                "%s, line %d: \"%s\" names no site, host, controller, member, observer, guest, viewer, operator or administrator"
                    .formatted(source, number, line));
      }
    }
    return new SiteUsers(site, hosts, controllers, members, observers, guests, persons);
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
