package org.maestro.agents.faces;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Self;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** A member that is a face, as its description says: it has the routine that speaks with one. */
record FaceMember(Device device) {
  static final String SAY = "sayWithFace";
  static final String SHOW = "showFace";
  static final String EXPRESS = "express";
  static final String LOOK = "lookAt";
  static final String NOD = "nod";
  static final String SHAKE = "shakeHead";

  /** The input of {@link #SAY} that stands for who hears it. */
  static final String TO = "to";

  /**
   * Those at which somebody sees who speaks to him, as far as it is known.
   *
   * @param listener a person, or a room
   */
  static List<FaceMember> seenBy(String listener, Home home, Snapshot now) {
    Evaluation evaluation = new Evaluation(now);
    return home.devices().values().stream()
        .map(FaceMember::new)
        .filter(
            face ->
                face.feature(SAY).filter(say -> face.isSeen(say, listener, evaluation)).isPresent())
        .toList();
  }

  private boolean isSeen(FeatureType say, String listener, Evaluation evaluation) {
    Map<String, Term> bindings = Self.is(device.id(), Map.of(TO, new Term.Name(listener)));
    return evaluation.truth(say.precondition(), bindings) == Truth.TRUE;
  }

  /**
   * The feature that a routine carries out.
   *
   * @param procedure the routine's key
   */
  Optional<FeatureType> feature(String procedure) {
    return device.features().stream()
        .filter(feature -> feature.procedure().equals(procedure))
        .findFirst();
  }
}
