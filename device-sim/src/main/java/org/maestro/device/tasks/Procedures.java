package org.maestro.device.tasks;

import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import org.maestro.hal.HeadGesture;
import org.maestro.rats.member.Procedure;

/**
 * The routines of this software, by the key under which descriptions name them. One registry
 * belongs to one device, since routines of a device may share what is under way.
 */
public final class Procedures {

  private static final String TURN = "turn";
  private static final String DRIVE = "drive";
  private static final String TRANSMIT = "transmit";

  /** What another would do from where it is itself, which is something else. */
  private static final Set<String> OF_ITSELF = Set.of(TURN, DRIVE, TRANSMIT);

  private final Map<String, Kind> kinds = new TreeMap<>();

  /**
   * @param runningState the device's state while it runs
   */
  private record Kind(String runningState, Function<FeatureContext, Procedure> maker) {}

  public Procedures() {
    Observations observations = new Observations();
    kinds.put(
        "observeObject",
        new Kind("observing", context -> new ObserveObject(context, observations)));
    kinds.put("lookAround", new Kind("observing", LookAround::new));
    kinds.put("stopObserve", new Kind("observing", context -> new StopObserve(observations)));
    kinds.put("takeStock", new Kind("reading", TakeStock::new));
    kinds.put("measureIllumination", new Kind("measuring", MeasureIllumination::new));
    kinds.put("adjustLight", new Kind("adjusting", AdjustLight::new));
    kinds.put("adjustShutter", new Kind("shutter-in-movement", AdjustShutter::new));
    kinds.put("openDoor", new Kind("door-in-movement", context -> new SetDoor(context, true)));
    kinds.put("closeDoor", new Kind("door-in-movement", context -> new SetDoor(context, false)));
    kinds.put("switchOn", new Kind("switching", context -> new SetSwitch(context, true)));
    kinds.put("switchOff", new Kind("switching", context -> new SetSwitch(context, false)));
    kinds.put("set", new Kind("switching", SetSettings::new));
    kinds.put("listen", new Kind("listening", ListenTask::new));
    kinds.put("streamPictures", new Kind("streaming", StreamPictures::new));
    kinds.put("streamSound", new Kind("streaming", StreamSound::new));
    kinds.put("stopStreaming", new Kind("streaming", context -> new StopStreaming()));
    kinds.put("say", new Kind("speaking", SayTask::new));
    kinds.put("move", new Kind("driving", MoveTask::new));
    kinds.put("pick", new Kind("arm-in-movement", context -> new PickTask(context, "object")));
    kinds.put(
        "takeOut", new Kind("arm-in-movement", context -> new PickTask(context, "container")));
    kinds.put("place", new Kind("arm-in-movement", context -> new PlaceTask(context, false)));
    kinds.put("putInto", new Kind("arm-in-movement", context -> new PlaceTask(context, true)));
    kinds.put("sweep", new Kind("sweeping", SweepTask::new));
    kinds.put("recharge", new Kind("charging", RechargeTask::new));
    kinds.put(TURN, new Kind("turning", TurnTask::new));
    kinds.put(DRIVE, new Kind("driving", DriveTask::new));
    kinds.put("goTo", new Kind("driving", GoToTask::new));
    kinds.put("halt", new Kind("halting", HaltTask::new));
    kinds.put("readSignal", new Kind("measuring", ReadSignal::new));
    kinds.put(TRANSMIT, new Kind("transmitting", TransmitTask::new));
    kinds.put("showFace", new Kind("expressing", ShowFace::new));
    kinds.put("express", new Kind("expressing", ExpressTask::new));
    kinds.put("lookAt", new Kind("looking", LookAt::new));
    kinds.put("pointAt", new Kind("gesturing", PointAt::new));
    kinds.put("nod", new Kind("gesturing", context -> new MoveHead(context, HeadGesture.NOD)));
    kinds.put(
        "shakeHead", new Kind("gesturing", context -> new MoveHead(context, HeadGesture.SHAKE)));
    kinds.put("sayWithFace", new Kind("speaking", SayWithFace::new));
  }

  /**
   * @throws DeviceSetupException when there is no such routine, or no driver for it
   */
  public Procedure procedure(FeatureContext context) {
    return kind(context).maker().apply(context);
  }

  public String runningState(FeatureContext context) {
    return kind(context).runningState();
  }

  /** Whether a routine means the device that is told, so that no other does it in its place. */
  public boolean isOfItself(String procedure) {
    return OF_ITSELF.contains(procedure);
  }

  private Kind kind(FeatureContext context) {
    Kind kind = kinds.get(context.feature().procedure());
    if (kind == null) {
      throw new DeviceSetupException(
          "The device "
              + context.device()
              + " offers "
              + context.feature().name()
              + " with the procedure "
              + context.feature().procedure()
              + ", which is none of "
              + String.join(", ", kinds.keySet())
              + ".");
    }
    return kind;
  }
}
