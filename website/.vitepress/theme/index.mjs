import DefaultTheme from "vitepress/theme";
import MovingPicture from "./MovingPicture.vue";
import "./style.css";

export default {
  extends: DefaultTheme,
  enhanceApp: ({ app }) => app.component("MovingPicture", MovingPicture),
};
