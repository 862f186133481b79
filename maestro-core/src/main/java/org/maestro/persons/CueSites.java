package org.maestro.persons;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.PersonCue;
import org.maestro.ontology.home.PersonTracking;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** All cues that may be told in a home, those that name the person first. */
final class CueSites {
  /** The geometry function by which a device stands in a zone. */
  private static final String INSIDE = "inside";

  private static final List<Optional<String>> NOBODY_NAMED = List.of(Optional.empty());

  private final Home home;
  private final Snapshot facts;
  private final List<String> persons;
  private final List<String> zones;

  CueSites(Home home, Snapshot facts, List<String> persons, List<String> zones) {
    this.home = home;
    this.facts = facts;
    this.persons = persons;
    this.zones = zones;
  }

  /** Who is known is no guest: so what names nobody comes last. */
  List<CueSite> of(PersonTracking tracking) {
    List<CueSite> sites = new ArrayList<>();
    for (PersonCue cue : tracking.cues()) {
      if (cue.isOfDevices()) {
        home.devices().values().stream()
            .filter(device -> device.individual().classes().contains(cue.of()))
            .forEach(device -> add(cue, Optional.of(device.id()), sites));
      } else {
        add(cue, Optional.empty(), sites);
      }
    }
    sites.sort(Comparator.comparing(site -> site.person().isEmpty()));
    return List.copyOf(sites);
  }

  private void add(PersonCue cue, Optional<String> device, List<CueSite> sites) {
    List<String> where =
        cue.namesTheZone() || device.isEmpty()
            ? zones
            : zones.stream().filter(zone -> isIn(device.get(), zone)).toList();
    for (String zone : where) {
      for (Optional<String> person :
          cue.namesThePerson() ? persons.stream().map(Optional::of).toList() : NOBODY_NAMED) {
        Map<String, Term> names = new HashMap<>();
        device.ifPresent(name -> names.put(Self.NAME, new Term.Name(name)));
        person.ifPresent(name -> names.put(PersonCue.PERSON, new Term.Name(name)));
        names.put(PersonCue.ZONE, new Term.Name(zone));
        sites.add(new CueSite(cue, new Substitution(names).apply(cue.fact()), person, zone));
      }
    }
  }

  private boolean isIn(String device, String zone) {
    Formula.Atom inside =
        new Formula.Atom(INSIDE, List.of(new Term.Name(device), new Term.Name(zone)));
    return facts.truth(inside) == Truth.TRUE;
  }
}
