package org.maestro.ontology.home;

import java.time.ZoneId;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.ontology.wording.Wording;

/**
 * A home: the map and the devices, with the vocabulary that describes them. Keyed by local name.
 * Immutable; devices and group agents are among the individuals too.
 *
 * @param scripts how things are done in it, by their names
 * @param rules what begins in it by itself, by their names
 * @param timeZone of the clocks on its walls; empty: that of the machine on which one asks
 * @param wording what its words are called in the languages of people
 * @param words what its file adds to the vocabulary that is shipped, as Turtle; empty when it adds
 *     nothing
 * @param file its file's name, such as {@code bob.ttl}; empty: it was not read from one
 * @param tracking how its persons are followed; empty: they are not
 */
public record Home(
    String iri,
    String label,
    Vocabulary vocabulary,
    Map<String, Individual> individuals,
    Map<String, Device> devices,
    Map<String, Group> groups,
    Map<String, Script> scripts,
    Map<String, Rule> rules,
    Optional<ZoneId> timeZone,
    Wording wording,
    String words,
    Optional<String> file,
    Optional<PersonTracking> tracking) {
  private static final String PERMISSION = "Permission";

  public Home {
    individuals = Collections.unmodifiableMap(new LinkedHashMap<>(new TreeMap<>(individuals)));
    devices = Collections.unmodifiableMap(new TreeMap<>(devices));
    groups = Collections.unmodifiableMap(new TreeMap<>(groups));
    scripts = Collections.unmodifiableMap(new TreeMap<>(scripts));
    rules = Collections.unmodifiableMap(new TreeMap<>(rules));
  }

  /** The same home with these scripts. */
  public Home withScripts(Map<String, Script> others) {
    return new Home(
        iri,
        label,
        vocabulary,
        individuals,
        devices,
        groups,
        others,
        rules,
        timeZone,
        wording,
        words,
        file,
        tracking);
  }

  /** The same home with these devices; the others are things of it only. */
  public Home withDevices(Map<String, Device> others) {
    return new Home(
        iri,
        label,
        vocabulary,
        individuals,
        others,
        groups,
        scripts,
        rules,
        timeZone,
        wording,
        words,
        file,
        tracking);
  }

  /** The same home, whose clocks show the time of that zone. */
  public Home in(ZoneId zone) {
    return new Home(
        iri,
        label,
        vocabulary,
        individuals,
        devices,
        groups,
        scripts,
        rules,
        Optional.of(zone),
        wording,
        words,
        file,
        tracking);
  }

  /** A home without scripts and words of its own. */
  public Home(
      String iri,
      String label,
      Vocabulary vocabulary,
      Map<String, Individual> individuals,
      Map<String, Device> devices,
      Map<String, Group> groups) {
    this(
        iri,
        label,
        vocabulary,
        individuals,
        devices,
        groups,
        Map.of(),
        Map.of(),
        Optional.empty(),
        Wording.NONE,
        "",
        Optional.empty(),
        Optional.empty());
  }

  /** A home without group agents and words of its own. */
  public Home(
      String iri,
      String label,
      Vocabulary vocabulary,
      Map<String, Individual> individuals,
      Map<String, Device> devices) {
    this(iri, label, vocabulary, individuals, devices, Map.of());
  }

  /** The same home with other things and words: what somebody knows of it who knows less. */
  public Home knownAs(Map<String, Individual> things, Wording asCalled) {
    return new Home(
        iri,
        label,
        vocabulary,
        things,
        devices,
        groups,
        scripts,
        rules,
        timeZone,
        asCalled,
        words,
        file,
        tracking);
  }

  /** The permissions that it states, by their names. */
  public Map<String, Individual> permissions() {
    Map<String, Individual> stated = new TreeMap<>();
    of(PERMISSION).forEach(one -> stated.put(one.name(), one));
    return stated;
  }

  /** The same home with these permissions in the place of its own. */
  public Home withPermissions(Map<String, Individual> others) {
    Map<String, Individual> things = new TreeMap<>(individuals);
    things.keySet().removeAll(permissions().keySet());
    things.putAll(others);
    return knownAs(things, wording);
  }

  /** The agent that hears what is said in a room, if one does. */
  public Optional<Group> listener(String room) {
    return groups.values().stream()
        .filter(group -> group.hearing().filter(its -> its.rooms().contains(room)).isPresent())
        .findFirst();
  }

  /** Its things of a class, by name. */
  List<Individual> of(String className) {
    return individuals.values().stream()
        .filter(individual -> individual.classes().contains(className))
        .toList();
  }

  /**
   * The same home with this device, or with what it now says of itself: with the words and things
   * that its description brings, without things that nobody brings any more.
   */
  public Home with(Device device) {
    Map<String, Individual> things = new TreeMap<>(individuals);
    Map<String, Device> joined = new TreeMap<>(devices);
    Device before = joined.put(device.id(), device);
    if (before != null) {
      before.extension().things().keySet().stream()
          .filter(name -> joined.values().stream().noneMatch(other -> other.brings(name)))
          .filter(name -> !joined.containsKey(name))
          .forEach(things::remove);
    }
    device
        .extension()
        .things()
        .forEach(
            (name, thing) -> {
              if (!joined.containsKey(name)) {
                things.put(name, thing);
              }
            });
    things.put(device.id(), device.individual());
    return new Home(
        iri,
        label,
        vocabulary.with(device.extension().wordsBeside(vocabulary)),
        things,
        joined,
        groups,
        scripts,
        rules,
        timeZone,
        wording,
        words,
        file,
        tracking);
  }

  /** The same home with this agent of a room, or of another group. */
  public Home with(Group group) {
    Map<String, Individual> things = new TreeMap<>(individuals);
    things.put(group.id(), group.individual());
    Map<String, Group> joined = new TreeMap<>(groups);
    joined.put(group.id(), group);
    return withGroups(things, joined);
  }

  /** The same home without that agent of a group. */
  public Home withoutGroup(String group) {
    Map<String, Individual> things = new TreeMap<>(individuals);
    things.remove(group);
    Map<String, Group> left = new TreeMap<>(groups);
    left.remove(group);
    return withGroups(things, left);
  }

  private Home withGroups(Map<String, Individual> things, Map<String, Group> others) {
    return new Home(
        iri,
        label,
        vocabulary,
        things,
        devices,
        others,
        scripts,
        rules,
        timeZone,
        wording,
        words,
        file,
        tracking);
  }

  /**
   * Why the device cannot join with what its description brings: a word or a thing of that name is
   * there already, and is another one.
   */
  public Optional<Contradiction> contradiction(Device device) {
    Extension own = device.extension();
    List<Device> others =
        devices.values().stream().filter(other -> !other.id().equals(device.id())).toList();
    for (Device other : others) {
      Optional<Contradiction> ofWords = contradiction(own, other);
      if (ofWords.isPresent()) {
        return ofWords;
      }
    }
    Optional<Contradiction> ofItsName = nameTaken(device);
    if (ofItsName.isPresent()) {
      return ofItsName;
    }
    Device before = devices.get(device.id());
    for (Individual thing : own.things().values()) {
      Individual there = individuals.get(thing.name());
      boolean isOnlyItsOwn =
          before != null
              && before.brings(thing.name())
              && others.stream().noneMatch(other -> other.brings(thing.name()));
      boolean isADevice = devices.containsKey(thing.name()) || thing.name().equals(device.id());
      if (there != null && (isADevice || !isOnlyItsOwn && !there.equals(thing))) {
        return Optional.of(
            new Contradiction(
                "brings %s, and there is another %s here already (%s)"
                    .formatted(thing.name(), thing.name(), there.iri()),
                "give it another name"));
      }
    }
    return Optional.empty();
  }

  private static Optional<Contradiction> contradiction(Extension own, Device other) {
    Extension there = other.extension();
    Optional<String> crossed = own.synonyms().crossing(there.synonyms());
    if (crossed.isPresent()) {
      return Optional.of(
          new Contradiction(
              "says that its %s is a word of %s, which says the same the other way round"
                  .formatted(crossed.get(), other.id()),
              "say it in one of both descriptions, or in the home"));
    }
    return there
        .unlike(own)
        .map(
            word ->
                new Contradiction(
                    "declares the word %s, which %s declares otherwise (%s)"
                        .formatted(
                            own.synonyms().asSaid(word),
                            other.id(),
                            own.words().difference(there.words(), word)),
                    "give one of both another name, or tell in the home that both are the same"
                        + " (owl:equivalentProperty, owl:equivalentClass)"));
  }

  /** A place or a thing of the home is called so; what another device brought gives way. */
  private Optional<Contradiction> nameTaken(Device device) {
    boolean isTaken =
        individuals.containsKey(device.id())
            && !devices.containsKey(device.id())
            && devices.values().stream().noneMatch(other -> other.brings(device.id()));
    return isTaken
        ? Optional.of(
            new Contradiction(
                "has the name of something else that is here already",
                "give the device another id"))
        : Optional.empty();
  }
}
