package org.maestro.assembly;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.rats.gateway.LampRole;
import org.maestro.rats.gateway.ZigbeeLamp;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.sl.Self;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The lamps of a ZigBee gateway as lamps of a home: each stands for the device that has its name,
 * or that it was told to stand for, and is described as the home describes that one.
 */
public final class HomeLamps implements LampRole {

  private static final Logger LOG = LoggerFactory.getLogger(HomeLamps.class);

  /** How descriptions name the routine that sets a light, and the word for what it gives. */
  private static final String ROUTINE = "adjustLight";

  private static final String LEVEL = "level";

  /** The gateway's way to the lamp and back; stated assumption. */
  private static final double SECONDS = 0.4;

  private final Map<String, Device> devices = new TreeMap<>();
  private final Map<String, String> idByName;
  private final DescriptionWriter descriptions;
  private final FeatureType feature;

  /**
   * @param idByName the home's device by the lamp's friendly name, where they differ
   * @throws IllegalArgumentException with one sentence when the home has no such lamps
   */
  public HomeLamps(Home home, Map<String, String> idByName) {
    List<FeatureType> features = new ArrayList<>();
    for (Device device : home.devices().values()) {
      light(device)
          .ifPresent(
              found -> {
                devices.put(device.id(), device);
                features.add(found);
              });
    }
    if (devices.isEmpty()) {
      throw new IllegalArgumentException(
          "The home has no lamp: no device offers a feature with the procedure " + ROUTINE + ".");
    }
    for (String id : new TreeSet<>(idByName.values())) {
      if (!devices.containsKey(id)) {
        throw new IllegalArgumentException(
            "The home has no lamp %s; it has %s."
                .formatted(id, String.join(", ", devices.keySet())));
      }
    }
    this.feature = features.get(0);
    Optional<FeatureType> other =
        features.stream().filter(f -> !f.name().equals(feature.name())).findFirst();
    if (other.isPresent()) {
      throw new IllegalArgumentException(
          "Lamps of one gateway have one feature, and this home has %s and %s."
              .formatted(feature.name(), other.get().name()));
    }
    this.idByName = Map.copyOf(idByName);
    this.descriptions = new DescriptionWriter(home);
  }

  private static Optional<FeatureType> light(Device device) {
    return device.features().stream()
        .filter(feature -> feature.procedure().equals(ROUTINE))
        .filter(feature -> !feature.inputs().isEmpty())
        .findFirst();
  }

  /** The home's lamps, of which any may be one of the gateway's. */
  public List<String> ids() {
    return List.copyOf(devices.keySet());
  }

  @Override
  public Optional<String> id(ZigbeeLamp lamp) {
    String id = idByName.getOrDefault(lamp.name(), lamp.name());
    if (devices.containsKey(id)) {
      return Optional.of(id);
    }
    LOG.info("The lamp {} ({}) is none of this home's", lamp.name(), lamp.address());
    return Optional.empty();
  }

  private Device lamp(String id) {
    return Objects.requireNonNull(devices.get(id));
  }

  @Override
  public String description(String id, ZigbeeLamp lamp) {
    return descriptions.write(lamp(id));
  }

  @Override
  public String feature() {
    return feature.name();
  }

  @Override
  public String parameter() {
    return feature.inputs().stream()
        .filter(input -> !input.optional())
        .map(Parameter::name)
        .findFirst()
        .orElseGet(() -> feature.inputs().get(0).name());
  }

  @Override
  public String fact(String id, double level) {
    Map<String, Term> values = Map.of(Self.NAME, new Term.Name(id), LEVEL, new Term.Number(level));
    String template = lamp(id).reports().getOrDefault(LEVEL, "(= (level ?self) ?level)");
    return SlPrinter.print(new Substitution(values).apply(SlParser.fact(template)));
  }

  @Override
  public CostAnswer cost(String id, Optional<Double> now, double level) {
    return new CostAnswer(Optional.of(SECONDS), Optional.of(SECONDS), Optional.empty());
  }
}
