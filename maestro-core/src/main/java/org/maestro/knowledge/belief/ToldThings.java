package org.maestro.knowledge.belief;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Extension;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.ClassDeclaration;
import org.maestro.rats.bounded.BoundedMap;
import org.maestro.sl.Fact;
import org.maestro.sl.Term;

/**
 * Things that devices tell to be there, a can in stock or a parcel that came, each by a fact of its
 * class, {@code (Can can-7)}. A thing that its device does not tell any more is gone, unless
 * something else is known of it. One writer at a time.
 */
public final class ToldThings {

  private static final int MOST_REMEMBERED = 256;

  private final Map<String, Device> described = new TreeMap<>();
  private final Map<String, Map<String, Individual>> byDevice = new TreeMap<>();
  private final Map<String, Map<String, Individual>> gone = new TreeMap<>();

  /** The device describes itself so from now on. */
  public void described(Device device) {
    described.put(device.id(), device);
  }

  /** A device of the home with the things that it has told to be there by now. */
  public Device present(Device inHome) {
    return with(described.getOrDefault(inHome.id(), inHome));
  }

  /** A device, as it describes itself, with the things that it has told to be there by now. */
  public Device with(Device device) {
    Map<String, Individual> told = byDevice.getOrDefault(device.id(), Map.of());
    if (told.isEmpty()) {
      return device;
    }
    Extension own = device.extension();
    Map<String, Individual> all = new TreeMap<>(told);
    all.putAll(own.things());
    return device.bringing(own.with(all));
  }

  /** Notes what the device tells to be there now, beside what it has told before. */
  public void add(Home home, Device device, List<Fact> facts) {
    // A device has come that is called so.
    byDevice.getOrDefault(device.id(), new TreeMap<>()).keySet().removeAll(home.devices().keySet());
    Map<String, Individual> told = told(home, device, facts);
    if (!told.isEmpty()) {
      described.putIfAbsent(device.id(), device);
      byDevice.computeIfAbsent(device.id(), id -> new TreeMap<>()).putAll(told);
    }
  }

  /** Forgets what the device does not tell any more, and of which nothing else is known. */
  public void keepOnly(World world, Device device, List<Fact> facts) {
    Map<String, Individual> known = byDevice.getOrDefault(device.id(), Map.of());
    if (!known.isEmpty()) {
      Set<String> told = told(world.home(), device, facts).keySet();
      Map<String, Individual> gone = new TreeMap<>(known);
      gone.keySet().removeIf(name -> told.contains(name) || isKnownOf(world, name));
      known.keySet().removeAll(gone.keySet());
      goneOf(device.id()).putAll(gone);
    }
  }

  /**
   * The device's step was about these; what it did with a thing that it tells no more may come to
   * be known after that. Returns whether one is there again.
   */
  public boolean recall(World world, String device, Collection<Term> bindings) {
    boolean isOneBack = false;
    for (Term term : bindings) {
      if (term instanceof Term.Name name
          && goneOf(device).containsKey(name.text())
          && !world.home().individuals().containsKey(name.text())
          && isKnownOf(world, name.text())) {
        byDevice
            .computeIfAbsent(device, id -> new TreeMap<>())
            .put(name.text(), Objects.requireNonNull(goneOf(device).remove(name.text())));
        isOneBack = true;
      }
    }
    return isOneBack;
  }

  private Map<String, Individual> goneOf(String device) {
    return gone.computeIfAbsent(device, id -> BoundedMap.ofNewest(MOST_REMEMBERED));
  }

  /** Whether the fact only says that there is a thing which no other tells of. */
  public boolean isOfAThing(Home home, Device device, Fact fact) {
    return thing(home, device, fact).isPresent();
  }

  private Map<String, Individual> told(Home home, Device device, List<Fact> facts) {
    Map<String, Individual> told = new TreeMap<>();
    for (Fact fact : facts) {
      thing(home, device, fact)
          .ifPresent(thing -> told.merge(thing.name(), thing, ToldThings::ofBothClasses));
    }
    return told;
  }

  private static Individual ofBothClasses(Individual one, Individual other) {
    Set<String> classes = new TreeSet<>(one.classes());
    classes.addAll(other.classes());
    return new Individual(one.name(), one.iri(), one.label(), classes, one.properties());
  }

  private Optional<Individual> thing(Home home, Device device, Fact fact) {
    if (!(fact instanceof Fact.Holds holds)
        || holds.atom().arguments().size() != 1
        || !(holds.atom().arguments().get(0) instanceof Term.Name name)) {
      return Optional.empty();
    }
    boolean isItsOwn =
        !home.devices().containsKey(name.text())
            && (byDevice.getOrDefault(device.id(), Map.of()).containsKey(name.text())
                || !home.individuals().containsKey(name.text()));
    String type = holds.atom().predicate();
    return Optional.ofNullable(home.vocabulary().classes().get(type))
        .filter(declared -> isItsOwn && Extension.mayBring(declared.ancestors()))
        .filter(declared -> home.vocabulary().predicate(type).isEmpty())
        .map(declared -> individual(declared, device, name.text()));
  }

  private static Individual individual(ClassDeclaration type, Device device, String name) {
    String iri = device.individual().iri();
    String namespace = iri.substring(0, iri.length() - device.id().length());
    return new Individual(name, namespace + name, name, type.ancestors(), Map.of());
  }

  private static boolean isKnownOf(World world, String name) {
    Term thing = new Term.Name(name);
    return world.variables().stream().anyMatch(variable -> speaksOf(world, variable, thing));
  }

  private static boolean speaksOf(World world, StateVariable variable, Term thing) {
    return world
        .cell(variable)
        .flatMap(Cell::value)
        .filter(held -> held.value().equals(thing) || variable.arguments().contains(thing))
        .isPresent();
  }
}
