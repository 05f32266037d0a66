// Brings the 3D views of a report to life: the figure of the robot, and those of sections that lead it.
(() => {
  const scene = JSON.parse(document.getElementById("gcrules-scene").textContent);

  // the figure keeps its drawing for paper and for browsers in which the viewer cannot start
  const figure = document.getElementById("gcrules-robot");
  const stage = document.createElement("div");
  stage.className = "stage";
  figure.prepend(stage);
  figure.classList.add("live");
  figure.hidden = false;
  try {
    window.robot = GcrulesViewer.explore(stage, scene);
  } catch (fault) {
    figure.classList.remove("live");
    stage.remove();
    throw fault;
  }
  const { pose, drive } = scene.start ?? {};
  if (pose) window.robot.setPose(pose);
  if (drive) window.robot.drive(drive);

  const SAME = 1e-3; // margins that differ by more are those of different configurations
  const calm = matchMedia("(prefers-reduced-motion: reduce)");

  /** A view that goes to the steps of its section; made when it comes into sight, for a page can hold few of them. */
  function lead(root) {
    const { about, steps } = JSON.parse(root.querySelector("script").textContent);
    const [range, play, output] = ["input", ".play", "output"].map((name) => root.querySelector(name));
    const buttons = [...root.parentElement.querySelectorAll("[data-step]")];
    const least = 6000 / steps.length; // milliseconds of a step
    let robot = null;
    let timer = 0;
    let lost = Infinity; // the first step to which the actuators do not lead
    let away = false; // whether the view stands elsewhere

    /** Whether the view gets to a step; a robot of joints goes there from where it is, or else along the way again. */
    function goes(step) {
      const { pose, scene: other } = steps[step];
      if (other) {
        robot.setScene(other);
        return true;
      }
      if (pose) {
        robot.setPose(pose);
        return true;
      }
      if (step >= lost) return false;
      if (away) robot.setScene({ ...scene, about });
      for (let k = away ? 0 : step; k <= step; k += 1) if (!met(steps[k], robot.drive(steps[k].drive))) return false;
      return true;
    }

    const met = ({ margin }, found) => !found || (found.reached && Math.abs(found.margin - margin) <= SAME);

    function show(step) {
      robot ??= GcrulesViewer.explore(root.querySelector(".stage"), { ...scene, about });
      const there = goes(step);
      if (!there) lost = Math.min(lost, step);
      away = !there;
      const { text } = steps[step];
      output.textContent = there ? text : `${text}; the view stands elsewhere: its actuators do not lead there from the start`;
      if (range) range.value = String(step);
      for (const button of buttons) button.setAttribute("aria-pressed", String(Number(button.dataset.step) === step));
    }

    function stop() {
      clearInterval(timer);
      timer = 0;
      if (play) play.textContent = "Play";
    }

    function start() {
      let step = Number(range.value) === steps.length - 1 ? 0 : Number(range.value);
      if (calm.matches) return show(steps.length - 1);
      play.textContent = "Pause";
      timer = setInterval(() => {
        show(step);
        step += 1;
        if (step === steps.length) stop();
      }, least);
    }

    root.hidden = false;
    for (const button of buttons) {
      button.hidden = false;
      button.addEventListener("click", () => {
        show(Number(button.dataset.step));
        root.scrollIntoView({ block: "nearest", behavior: calm.matches ? "auto" : "smooth" });
      });
    }
    range?.addEventListener("input", () => {
      stop();
      show(Number(range.value));
    });
    play?.addEventListener("click", () => (timer ? stop() : start()));
    const seen = new IntersectionObserver((entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      seen.disconnect();
      show(0);
    });
    seen.observe(root);
  }

  document.querySelectorAll(".lead").forEach(lead);
})();
