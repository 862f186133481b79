package org.maestro.device;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.device.tasks.FactTemplates;
import org.maestro.device.tasks.Motion;
import org.maestro.device.tasks.Numbers;
import org.maestro.hal.Area;
import org.maestro.hal.Battery;
import org.maestro.hal.DaylightSensor;
import org.maestro.hal.DimmableLamp;
import org.maestro.hal.DoorDrive;
import org.maestro.hal.Drivers;
import org.maestro.hal.Face;
import org.maestro.hal.FaceState;
import org.maestro.hal.GripperArm;
import org.maestro.hal.MobileBase;
import org.maestro.hal.PersonRecognition;
import org.maestro.hal.PresenceSensor;
import org.maestro.hal.Settings;
import org.maestro.hal.ShutterDrive;
import org.maestro.hal.Steering;
import org.maestro.hal.Surroundings;
import org.maestro.hal.Switch;
import org.maestro.hal.Thermometer;
import org.maestro.hal.WallClock;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.member.MemberProfile;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * The quantities that a device's drivers measure or hold of themselves, as the facts that its
 * description makes of them. Clock thread only.
 */
final class SelfReport implements MemberProfile.Values {

  private final FactTemplates reports;
  private final Drivers drivers;
  private final Motion motion;

  SelfReport(FactTemplates reports, Drivers drivers, Motion motion) {
    this.reports = reports;
    this.drivers = drivers;
    this.motion = motion;
  }

  @Override
  public List<String> current() {
    List<String> facts = new ArrayList<>();
    words().forEach((word, value) -> reports.statement(word, value).ifPresent(facts::add));
    motion.bars().stream()
        .sorted()
        .map(Term.Name::new)
        .forEach(name -> reports.statement("bar", name).ifPresent(facts::add));
    drivers
        .find(PersonRecognition.class)
        .ifPresent(
            sensor ->
                new TreeMap<>(sensor.persons())
                    .forEach(
                        (person, so) ->
                            reports
                                .statement("person", new Term.Name(person), so)
                                .ifPresent(facts::add)));
    return facts;
  }

  private Map<String, Term> words() {
    Map<String, Term> words = new TreeMap<>();
    drivers
        .find(DimmableLamp.class)
        .ifPresent(
            lamp -> {
              words.put("level", new Term.Number(lamp.level()));
              words.put("white", new Term.Number(lamp.whiteKelvin()));
            });
    drivers
        .find(ShutterDrive.class)
        .ifPresent(shutter -> words.put("opening", new Term.Number(shutter.opening())));
    drivers
        .find(DaylightSensor.class)
        .ifPresent(
            sensor -> {
              words.put("daylight", new Term.Number(sensor.diffuseLux()));
              words.put("sunlight", new Term.Number(sensor.sunLux()));
            });
    drivers
        .find(DoorDrive.class)
        .ifPresent(door -> words.put("open", new Term.Truth(door.isOpen())));
    drivers
        .find(PresenceSensor.class)
        .ifPresent(sensor -> words.put("presence", new Term.Truth(sensor.isSomebodyThere())));
    drivers
        .find(Thermometer.class)
        .ifPresent(thermometer -> words.put("temperature", new Term.Number(thermometer.celsius())));
    drivers
        .find(Switch.class)
        .ifPresent(appliance -> words.put("on", new Term.Truth(appliance.isOn())));
    drivers.find(Settings.class).ifPresent(appliance -> words.putAll(appliance.values()));
    drivers
        .find(WallClock.class)
        .ifPresent(clock -> words.put("minuteOfDay", new Term.Number(clock.minuteOfDay())));
    drivers
        .find(Battery.class)
        .ifPresent(battery -> words.put("charge", new Term.Number(battery.charge())));
    drivers.find(Face.class).ifPresent(face -> addFace(words, face.state()));
    drivers
        .find(GripperArm.class)
        .flatMap(GripperArm::held)
        .ifPresent(held -> words.put("holding", new Term.Name(held)));
    drivers.find(MobileBase.class).ifPresent(base -> addPlace(words, base.position()));
    drivers
        .find(Steering.class)
        .map(steering -> new Term.Number(Numbers.degreesAround(steering.heading())))
        .ifPresent(heading -> words.put("heading", heading));
    return words;
  }

  /** What is not there just now, such as a gesture, is not told. */
  private static void addFace(Map<String, Term> words, FaceState face) {
    if (!face.persona().isEmpty()) {
      words.put("persona", new Term.Text(face.persona()));
    }
    words.put("expression", new Term.Text(face.expression().word()));
    words.put("intensity", new Term.Number(face.intensity()));
    face.gaze()
        .ifPresent(
            gaze -> {
              words.put("looksAt", new Term.Name(gaze.thing()));
              words.put("gazeTurn", new Term.Number(Math.rint(gaze.turn())));
              words.put("gazeRise", new Term.Number(Math.rint(gaze.rise())));
            });
    face.gesture().ifPresent(gesture -> words.put("gesture", new Term.Text(gesture.word())));
    face.pointing().ifPresent(there -> words.put("pointsAt", new Term.Name(there.thing())));
    face.spoken()
        .ifPresent(
            spoken -> {
              words.put("saying", new Term.Text(spoken.text()));
              words.put("stress", new Term.Number(spoken.stress()));
            });
  }

  private void addPlace(Map<String, Term> words, Point2 position) {
    String text =
        "%s %s 0"
            .formatted(
                SlPrinter.print(Numbers.millimetres(position.x())),
                SlPrinter.print(Numbers.millimetres(position.y())));
    words.put("position", new Term.Text(text));
    Optional<Area> area =
        drivers.find(Surroundings.class).stream()
            .flatMap(surroundings -> surroundings.areas().stream())
            .filter(candidate -> candidate.outline().contains(position))
            .findFirst();
    area.ifPresent(inside -> words.put("zone", new Term.Name(inside.name())));
  }
}
