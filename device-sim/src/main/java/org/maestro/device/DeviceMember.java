package org.maestro.device;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.maestro.device.tasks.Deposits;
import org.maestro.device.tasks.DeviceSetupException;
import org.maestro.device.tasks.FactTemplates;
import org.maestro.device.tasks.FeatureContext;
import org.maestro.device.tasks.Motion;
import org.maestro.device.tasks.Procedures;
import org.maestro.hal.Drivers;
import org.maestro.hal.MobileBase;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.time.Clock;

/**
 * A described device with its drivers, ready to be run as a member. Its procedures and values are
 * used on the clock's thread only.
 */
public record DeviceMember(MemberProfile profile, MemberProfile.Values values, Motion motion) {

  private static final String STANDBY = "standby";
  private static final String SAFE = "safe";

  /**
   * @param description the document that the member publishes
   * @throws DeviceSetupException when the device offers what its drivers or this software cannot do
   */
  public static DeviceMember of(Device device, Drivers drivers, Clock clock, String description) {
    Procedures procedures = new Procedures();
    Set<String> states = new TreeSet<>(Set.of(STANDBY, SAFE));
    Map<String, MemberProfile.Feature> features = new LinkedHashMap<>();
    Deposits deposits = new Deposits();
    Motion motion = new Motion(clock, device.id());
    for (FeatureType type : device.features()) {
      FeatureContext context =
          FeatureContext.of(device.id(), type, drivers, clock, deposits, motion);
      String runningState = procedures.runningState(context);
      states.add(runningState);
      features.put(
          type.name(),
          new MemberProfile.Feature(
              type.name(),
              required(type),
              type.occupies(),
              type.continuous(),
              type.endedBy(),
              runningState,
              procedures.procedure(context)));
    }
    MemberProfile profile =
        new MemberProfile(device.id(), description, states, STANDBY, Set.of(SAFE), features);
    return new DeviceMember(
        profile.takingOver(canTakeOver(device, drivers, procedures)),
        new SelfReport(new FactTemplates(device.id(), device.reports()), drivers, motion),
        motion);
  }

  /** Who can go where another is at something can do it instead, unless it means that one alone. */
  private static Set<String> canTakeOver(Device device, Drivers drivers, Procedures procedures) {
    return drivers.find(MobileBase.class).isEmpty()
        ? Set.of()
        : device.features().stream()
            .filter(type -> !type.continuous() && !type.occupies().isEmpty())
            .filter(type -> !procedures.isOfItself(type.procedure()))
            .map(FeatureType::name)
            .collect(Collectors.toCollection(TreeSet::new));
  }

  private static Set<String> required(FeatureType type) {
    return type.inputs().stream()
        .filter(input -> !input.optional())
        .map(Parameter::name)
        .collect(Collectors.toCollection(TreeSet::new));
  }
}
